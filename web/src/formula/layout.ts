// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Lays out the tree of a formula. It computes nothing; what it does not know it writes as text. */
import type { Term } from '../protocol/messages.ts';
import { constant, quantity } from './numbers.ts';
import { type Piece, symbol, text } from './pieces.ts';

/** How tightly a part holds together; what holds less tightly than its surroundings ask for gets brackets. */
const level = { equation: 0, sum: 1, negative: 2, product: 3, fraction: 4, power: 5, atom: 6 } as const;
type Level = (typeof level)[keyof typeof level];
interface Part { pieces: readonly Piece[]; level: Level }
type Terms = ReadonlyMap<string, Term>;

const deepest = 24;

const atom = (...pieces: Piece[]): Part => ({ pieces, level: level.atom });
const bracketed = (part: Part): readonly Piece[] => [{ kind: 'bracket', inside: part.pieces }];
const atLeast = (part: Part, wanted: Level): readonly Piece[] => (part.level < wanted ? bracketed(part) : part.pieces);

function value(name: string, terms: Terms): Part {
  const term = terms.get(name);
  if (!term) return atom(symbol(name));
  const written = quantity(term.value, term.unit);
  const piece: Piece = { kind: 'value', ...written, name };
  return { pieces: [piece], level: (term.value ?? 0) < 0 ? level.negative : level.atom };
}

function number(n: unknown, unit: unknown): Part {
  if (typeof n !== 'number') return atom(text(String(n)));
  const written = constant(n, typeof unit === 'string' ? unit : '');
  return { pieces: [{ kind: 'value', ...written, name: '' }], level: n < 0 ? level.negative : level.atom };
}

function joined(parts: readonly (readonly Piece[])[], sign: string): Piece[] {
  return parts.flatMap((pieces, i) => (i === 0 ? [...pieces] : [text(sign), ...pieces]));
}

function sum(parts: readonly Part[]): Part {
  const inner = (part: Part, i: number): readonly Piece[] => (i > 0 && part.level === level.negative ? bracketed(part) : atLeast(part, level.sum));
  return { pieces: joined(parts.map(inner), ' + '), level: level.sum };
}

function difference(parts: readonly Part[]): Part {
  return { pieces: joined(parts.map((part, i) => atLeast(part, i === 0 ? level.sum : level.product)), ' − '), level: level.sum };
}

function product(parts: readonly Part[]): Part {
  return { pieces: joined(parts.map((part, i) => atLeast(part, i === 0 ? level.negative : level.product)), ' · '), level: level.product };
}

const isTwo = (tree: unknown): boolean => Array.isArray(tree) && tree[0] === 'num' && tree[1] === 2;

function fraction(over: Part, under: Part, underTree: unknown): Part {
  // "½x²" is lower than a fraction, and reads better within others.
  if (isTwo(underTree) && over.level >= level.fraction) {
    const startsWithBracket = over.pieces[0]?.kind === 'bracket' || (over.pieces[0]?.kind === 'power' && over.pieces[0].base[0]?.kind === 'bracket');
    return { pieces: [text(startsWithBracket ? '½' : '½ · '), ...over.pieces], level: level.product };
  }
  return { pieces: [{ kind: 'fraction', over: over.pieces, under: under.pieces }], level: level.fraction };
}

function power(base: Part, exponent: Part): Part {
  return { pieces: [{ kind: 'power', base: atLeast(base, level.atom), exponent: exponent.pieces }], level: level.power };
}

function applied(name: string, part: Part): Part {
  const inside = name === 'ln' && part.level >= level.fraction ? [text(' '), ...part.pieces] : bracketed(part);
  return { pieces: [{ kind: 'function', name }, ...inside], level: inside.length > 1 ? level.product : level.atom };
}

function unknown(name: string, parts: readonly Part[]): Part {
  return atom({ kind: 'function', name }, { kind: 'bracket', inside: joined(parts.map((part) => part.pieces), ', ') });
}

function part(tree: unknown, terms: Terms, depth: number): Part {
  if (depth > deepest) return atom(text('…'));
  if (!Array.isArray(tree)) return typeof tree === 'number' ? number(tree, '') : atom(text(String(tree)));
  const operation = String(tree[0]);
  const rest: readonly unknown[] = tree.slice(1);
  if (operation === 'sym') return atom(symbol(String(rest[0] ?? '')));
  if (operation === 'val') return value(String(rest[0] ?? ''), terms);
  if (operation === 'num') return number(rest[0], rest[1]);
  const parts = rest.map((child) => part(child, terms, depth + 1));
  const [first, second] = parts;
  if (!first) return unknown(operation, parts);
  switch (operation) {
    case 'eq': return { pieces: joined(parts.map((p) => p.pieces), ' = '), level: level.equation };
    case 'add': return sum(parts);
    case 'sub': return difference(parts);
    case 'mul': return product(parts);
    case 'neg': return { pieces: [text('−'), ...atLeast(first, level.product)], level: level.negative };
    case 'exp':
    case 'ln': return parts.length === 1 ? applied(operation, first) : unknown(operation, parts);
    case 'frac': return second ? fraction(first, second, rest[1]) : unknown(operation, parts);
    case 'pow': return second ? power(first, second) : unknown(operation, parts);
    default: return unknown(operation, parts);
  }
}

export function layOut(tree: unknown, terms: readonly Term[]): readonly Piece[] {
  return part(tree, new Map(terms.map((term) => [term.name, term])), 0).pieces;
}
