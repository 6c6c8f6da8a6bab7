// SPDX-License-Identifier: MIT
#include "app/command_render.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "app/program.hpp"
#include "base/error.hpp"

namespace hackle {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(RenderJob, TellsRunsOptionsAndTheFileToWriteApart) {
  const RenderJob job = render_job({"a.h5", "field=speed", "b.h5", "all.png", "range={0,1}"});
  EXPECT_THAT(job.runs, ElementsAre("a.h5", "b.h5"));
  EXPECT_EQ(job.out, "all.png");
  EXPECT_THAT(job.options, ElementsAre(Pair("field", "speed"), Pair("range", "{0,1}")));
  EXPECT_EQ(render_job({"a.h5"}).out, "");
  EXPECT_THAT(render_job({"a.h5", "b.h5"}).runs, ElementsAre("a.h5", "b.h5"));
}

TEST(RenderJob, NeedsARunAndAFileForItsOptions) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{}, {"field=speed"}, {"a.h5", "field=speed"}}) {
    try {
      render_job(words);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
}

std::string script(const std::vector<std::string>& words) {
  return script_of(render_job(words));
}

TEST(RenderScript, CallsTheFunctionThatMakesIt) {
  EXPECT_EQ(script({"a.h5", "x.png", "time=20*us"}),
            "(recording \"a.h5\"):frame { \"x.png\", time = 20*us }");
  EXPECT_EQ(script({"a.h5", "x.pdf"}), "(recording \"a.h5\"):frame { \"x.pdf\" }");
  EXPECT_EQ(script({"a.h5", "x.webm"}), "(recording \"a.h5\"):movie { \"x.webm\" }");
  EXPECT_EQ(script({"a.h5", "x.PNG", "times={0,1*us}"}),
            "contact_sheet { \"x.PNG\", times = {0,1*us}, recordings = { recording \"a.h5\" } }");
  EXPECT_EQ(script({"a.h5", "b.h5", "x.png"}),
            "contact_sheet { \"x.png\", recordings = { recording \"a.h5\", recording \"b.h5\" } }");
  EXPECT_EQ(script({"a.h5", "b.h5", "x.mp4", "columns=1"}),
            "side_by_side { \"x.mp4\", columns = 1, recordings = { recording \"a.h5\", recording "
            "\"b.h5\" } }");
}

TEST(RenderScript, NamesNeedNoQuotesAndKeepWhatTheyHold) {
  EXPECT_THAT(script({"a.h5", "x.png", "field=stress_1"}), HasSubstr("field = \"stress_1\""));
  EXPECT_THAT(script({"a.h5", "x.png", "field='speed'"}), HasSubstr("field = 'speed'"));
  EXPECT_THAT(script({"a\\\"b.h5", "x.png"}), HasSubstr("recording \"a\\\\\\\"b.h5\""));
  EXPECT_THAT(script({"a.h5", "x.png", "field=a\" }) os.exit()"}),
              HasSubstr("field = \"a\\\" }) os.exit()\""));
}

TEST(RenderScript, OffersTheNearestNameOfAnOption) {
  try {
    script({"a.h5", "x.png", "feld=speed"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("frame has no option 'feld' (did you mean 'field'?)"));
  }
}

class RenderTest : public testing::Test {
 protected:
  RenderTest() {
    std::ofstream(folder_.path / "a.lua")
        << test::scene << "s:record { 'a.h5', every = 1*us } s:run(3*us)";
    ran_ = program_.run({"run", "a.lua", "-o", "."});
  }
  bool made(const char* name) const { return fs::is_regular_file(folder_.path / name); }

  test::Folder folder_;
  test::Program program_{folder_};
  test::Ended ran_;
};

TEST_F(RenderTest, IsNamedAfterARunThatRecorded) {
  EXPECT_THAT(ran_.err, HasSubstr("next: hackle render ./a.h5"));
}

TEST_F(RenderTest, TellsWhatIsRecorded) {
  const test::Ended ended = program_.run({"render", "a.h5"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_THAT(ended.out, HasSubstr("a.h5: 4 records from 0 s to "));
  EXPECT_THAT(ended.out, HasSubstr("made by a.lua"));
  EXPECT_THAT(ended.out, HasSubstr("next: hackle render a.h5 a.png field="));
}

TEST_F(RenderTest, MakesPicturesMoviesAndSheets) {
  EXPECT_EQ(program_
                .run({"render", "a.h5", "x.png", "field=stress_1", "range={0,12*MPa}",
                      "zoom={60*mm,20*mm,10*mm}", "time=2*us", "width=320"})
                .code,
            0);
  EXPECT_EQ(program_.run({"render", "a.h5", "new/x.mp4", "width=320"}).code, 0);
  EXPECT_EQ(program_.run({"render", "a.h5", "a.h5", "y.png", "times={0,1*us}"}).code, 0);
  const test::Ended both = program_.run({"render", "a.h5", "a.h5", "y.mp4", "width=320"});
  EXPECT_EQ(both.code, 0);
  EXPECT_THAT(both.err, HasSubstr("wrote y.mp4 ("));
  for (const char* name : {"x.png", "y.png"}) EXPECT_TRUE(made(name)) << name;
  for (const char* name : {"new/x.mp4", "y.mp4"})
    EXPECT_TRUE(test::is_whole_mp4(folder_.path / name)) << name;
}

TEST_F(RenderTest, EndsWithTheCodeOfTheError) {
  struct Case {
    std::vector<std::string> words;
    int code;
    const char* message;
  };
  std::ofstream(folder_.path / "text.h5") << "text";
  for (const Case& c : {
           Case{{"render"}, 2, "FILES is required"},
           {{"render", "a.h5", "field=speed"}, 2, "there is no file to write"},
           {{"render", "a.h5", "x.png", "range={0,"}, 2, "range={0, is no value"},
           {{"render", "a.h5", "x.png", "feld=speed"}, 4, "did you mean 'field'?"},
           {{"render", "a.h5", "x.png", "field=sped"}, 4, "did you mean 'speed'?"},
           {{"render", "a.h5", "x.png", "width=321"}, 4, "width is 321"},
           {{"render", "none.h5", "x.png"}, 5, "there is no such file"},
           {{"render", "text.h5", "x.png"}, 5, "cannot read 'text.h5'"},
       }) {
    const test::Ended ended = program_.run(c.words);
    EXPECT_EQ(ended.code, c.code) << c.message;
    EXPECT_THAT(ended.err, HasSubstr(c.message));
  }
  EXPECT_FALSE(made("x.png"));
}

}  // namespace
}  // namespace hackle
