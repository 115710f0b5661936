// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

// All of Asio and Beast that is no template is compiled here, once.
#include <boost/asio/impl/src.hpp>
#include <boost/beast/src.hpp>
