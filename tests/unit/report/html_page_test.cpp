// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <gtest/gtest.h>

#include "report/base64.hpp"
#include "report/html_parts.hpp"
#include "small_document.hpp"

namespace echoarc::report {
namespace {

TEST(HtmlPage, HoldsEverythingAndNothingFromElsewhere) {
  const auto page = html_page(test::small_document());
  ASSERT_TRUE(page);
  EXPECT_TRUE(page->starts_with("<!DOCTYPE html>"));
  EXPECT_NE(page->find("Part &lt;1&gt; &amp; &quot;more&quot;"), std::string::npos);
  EXPECT_NE(page->find("A &lt; B, that&#39;s it."), std::string::npos);
  EXPECT_NE(page->find("<svg"), std::string::npos);
  EXPECT_NE(page->find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(page->find("href=\"#paper-part\""), std::string::npos);
  EXPECT_NE(page->find("id=\"paper-part\""), std::string::npos);
  EXPECT_EQ(page->find("<script"), std::string::npos);
  EXPECT_EQ(page->find("src=\"http"), std::string::npos);
  EXPECT_EQ(page->find("href=\"http"), std::string::npos);
  EXPECT_EQ(page->find("nan"), std::string::npos);
}

TEST(HtmlPage, CountsClaims) {
  const std::string page = html_page(test::small_document()).value();
  EXPECT_NE(page.find("<b>paper</b></a></td><td class=\"n\"><b>1</b></td><td class=\"n\"><b>1</b></td>"
                      "<td class=\"n\"><b>1</b></td>"),
            std::string::npos);
  EXPECT_NE(page.find("chip yes\">holds"), std::string::npos);
  EXPECT_NE(page.find("chip no\">does not hold"), std::string::npos);
  EXPECT_NE(page.find("chip open\">cannot be told"), std::string::npos);
}

TEST(HtmlPage, TablesShowPaperBesideOurs) {
  const studies::StudySection section = test::small_document().studies.front().sections.front();
  const std::string rows = table(section.tables[0]);
  EXPECT_NE(rows.find("<td class=\"n\">2.50</td><td class=\"n\"><b>2.00</b> <span class=\"sd\">±0.10</span></td>"),
            std::string::npos);
  EXPECT_NE(rows.find("1.90 … 2.10"), std::string::npos);
  EXPECT_NE(rows.find("&gt; 20 %"), std::string::npos);
  const std::string matrix = table(section.tables[1]);
  EXPECT_NE(matrix.find("<th colspan=\"2\" class=\"c\">MAE"), std::string::npos);
  EXPECT_EQ(table({}), "");
}

TEST(HtmlPage, APictureThatIsNoneIsAnError) {
  ReportDocument document = test::small_document();
  document.studies.front().sections.front().pictures.front().image.rgb.clear();
  document.studies.front().sections.front().pictures.front().image.width = 0;
  EXPECT_FALSE(html_page(document));
}

TEST(Base64, OfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(HtmlParts, Numbers) {
  EXPECT_EQ(number(1.005, 1), "1.0");
  EXPECT_EQ(number(-0.5, 2), "-0.50");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity(), 2), "–");
}

}  // namespace
}  // namespace echoarc::report
