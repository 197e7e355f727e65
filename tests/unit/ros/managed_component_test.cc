// Managed components: transitions, parameters that make no sense, what is refused and why.
#include "components/ros/managed_component.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

#include "tests/unit/ros/support.h"

namespace goalnet::ros {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using State = LifecycleState;

// Notes what it is asked to do, and fails or throws where a test wants it to.
class Toy : public ManagedComponent {
 public:
  struct Params {
    std::string file = "good";
    double rate = 10.0;
    std::string mode = "calm";
    bool fixed = false;
    int retries = 3;
  };
  static void describe(ParameterSet& set, Params& params) {
    set.text("file", params.file, "what to load", "a file");
    set.number("rate", params.rate, "how often [Hz]", 1.0, 100.0);
    set.choice("mode", params.mode, "how", {"calm", "wild"});
    set.flag("fixed", params.fixed, "cannot change").settable = Settable::kAtStart;
    set.whole("retries", params.retries, "tries", 0, 9).settable = Settable::kAnyTime;
  }
  explicit Toy(Node& node) : ManagedComponent(node) { describe(parameters_, params); }

  Params params;
  std::vector<std::string> work;
  std::string fail_in, throw_in;
  int set = 0;

 private:
  Expected<void> did(const std::string& what) {
    work.push_back(what);
    if (what == throw_in) throw std::runtime_error("broke in " + what);
    if (what == fail_in) return fail(Outcome::kInvalidRequest, "cannot " + what);
    return {};
  }
  Expected<void> on_configure() override {
    if (params.file == "bad") return fail(Outcome::kInvalidRequest, "there is no file bad");
    return did("configure");
  }
  Expected<void> on_activate() override { return did("activate"); }
  Expected<void> on_deactivate() override { return did("deactivate"); }
  Expected<void> on_cleanup() override { return did("cleanup"); }
  void on_parameter_set() override { ++set; }
};

struct ManagedComponentTest : testing::Test {
  std::unique_ptr<Context> context =
      Context::create({.domain_id = own_domain(), .process_only = true}).value();
  EventLoop loop;
  std::unique_ptr<Node> node;
  std::unique_ptr<Toy> toy;

  Expected<void> start(std::vector<std::string> parameters) {
    std::vector<std::string> words = {"--ros-args"};
    for (auto& one : parameters) words.insert(words.end(), {"-p", one});
    NodeOptions options = plain("toy");
    options.arguments = parse_arguments(words).value();
    options.arguments.console = false;
    node = std::make_unique<Node>(*context, loop, std::move(options));
    toy = std::make_unique<Toy>(*node);
    return toy->begin();
  }
  std::string set(const std::string& name, ParameterValue value) {
    const auto done = node->parameters().set({{name, std::move(value)}});
    return done ? "" : done.error().message;
  }
};

TEST_F(ManagedComponentTest, StartsByItselfUnlessToldNotTo) {
  ASSERT_TRUE(start({}));
  EXPECT_TRUE(toy->active());
  EXPECT_THAT(toy->work, ElementsAre("configure", "activate"));
  toy.reset();
  node.reset();
  ASSERT_TRUE(start({"autostart:=false"}));
  EXPECT_EQ(toy->state(), State::kUnconfigured);
  EXPECT_THAT(toy->work, ElementsAre());
  EXPECT_THAT(set("autostart", true), HasSubstr("read-only"));
}

TEST_F(ManagedComponentTest, GoesThroughEveryTransitionTwice) {
  ASSERT_TRUE(start({"autostart:=false"}));
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(toy->configure());
    EXPECT_EQ(toy->state(), State::kInactive);
    EXPECT_TRUE(toy->activate());
    EXPECT_TRUE(toy->deactivate());
    EXPECT_TRUE(toy->activate());
    EXPECT_TRUE(toy->deactivate());
    EXPECT_TRUE(toy->cleanup());
    EXPECT_EQ(toy->state(), State::kUnconfigured);
  }
  EXPECT_TRUE(toy->configure());
  EXPECT_TRUE(toy->activate());
  toy->work.clear();
  EXPECT_TRUE(toy->shutdown());
  EXPECT_EQ(toy->state(), State::kFinalized);
  EXPECT_THAT(toy->work, ElementsAre("deactivate", "cleanup"));
  EXPECT_FALSE(toy->configure()) << "what is finalized stays so";
}

TEST_F(ManagedComponentTest, SaysWhichTransitionIsNotPossible) {
  ASSERT_TRUE(start({"autostart:=false"}));
  for (const auto change : {&Toy::activate, &Toy::deactivate, &Toy::cleanup}) {
    const auto done = (*toy.*change)();
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().outcome, Outcome::kInvalidRequest);
    EXPECT_THAT(done.error().message, HasSubstr("in state unconfigured"));
  }
  EXPECT_THAT(toy->work, ElementsAre());
}

TEST_F(ManagedComponentTest, AFailingConfigureCanBeTriedAgainAfterASetting) {
  ASSERT_TRUE(start({"autostart:=false", "file:=bad"}));
  const auto failed = toy->configure();
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "there is no file bad");
  EXPECT_EQ(toy->state(), State::kUnconfigured);
  EXPECT_THAT(toy->work, ElementsAre("cleanup")) << "nothing half loaded stays";
  EXPECT_EQ(set("file", std::string("good")), "");
  EXPECT_TRUE(toy->configure());
  EXPECT_EQ(toy->params.file, "good");
}

TEST_F(ManagedComponentTest, ValuesFromTheCommandLineThatMakeNoSenseFailConfigureUntilSetRight) {
  ASSERT_TRUE(start({"autostart:=false", "rate:=1000.0", "mode:=angry", "retries:=many"}));
  EXPECT_THAT(toy->configure().error().message, HasSubstr("mode")) << "the first by name";
  EXPECT_EQ(set("mode", std::string("wild")), "");
  EXPECT_THAT(toy->configure().error().message, HasSubstr("'rate': 1000 is not within 1 .. 100"));
  EXPECT_EQ(set("rate", 50.0), "");
  EXPECT_THAT(toy->configure().error().message, HasSubstr("must be an integer"));
  EXPECT_EQ(set("retries", std::int64_t{2}), "");
  ASSERT_TRUE(toy->configure());
  EXPECT_EQ(toy->params.mode, "wild");
  EXPECT_EQ(toy->params.rate, 50.0);
  EXPECT_EQ(toy->params.retries, 2);
}

TEST_F(ManagedComponentTest, WithAutostartTheReasonIsReturned) {
  const auto begun = start({"file:=bad"});
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().message, "there is no file bad");
}

TEST_F(ManagedComponentTest, SettingsAreRefusedWithAReason) {
  ASSERT_TRUE(start({}));
  EXPECT_THAT(set("rate", 20.0), HasSubstr("while the node is unconfigured; it is active"));
  EXPECT_EQ(set("rate", 10.0), "") << "no change";
  EXPECT_THAT(set("fixed", true), HasSubstr("read-only"));
  EXPECT_THAT(set("retries", std::int64_t{10}), HasSubstr("10 is not within 0 .. 9"));
  EXPECT_THAT(set("retries", 2.0), HasSubstr("is of type integer, not double"));
  EXPECT_THAT(set("nothing", 2.0), HasSubstr("is not declared"));
  EXPECT_EQ(set("retries", std::int64_t{7}), "");
  EXPECT_EQ(toy->params.retries, 7) << "at once";
  EXPECT_EQ(toy->set, 1);
  ASSERT_TRUE(toy->deactivate());
  ASSERT_TRUE(toy->cleanup());
  EXPECT_THAT(set("mode", std::string("angry")), HasSubstr("\"angry\" is not calm or wild"));
  EXPECT_EQ(set("rate", 20.0), "");
  EXPECT_EQ(toy->params.rate, 10.0) << "with the next configure";
  ASSERT_TRUE(toy->configure());
  EXPECT_EQ(toy->params.rate, 20.0);
}

TEST_F(ManagedComponentTest, FailuresLeaveTheStateAndExceptionsLetGoOfEverything) {
  ASSERT_TRUE(start({"autostart:=false"}));
  toy->fail_in = "activate";
  ASSERT_TRUE(toy->configure());
  EXPECT_EQ(toy->activate().error().message, "cannot activate");
  EXPECT_EQ(toy->state(), State::kInactive);
  toy->fail_in.clear();
  ASSERT_TRUE(toy->activate());
  toy->fail_in = "deactivate";
  EXPECT_FALSE(toy->deactivate());
  EXPECT_TRUE(toy->active());
  toy->fail_in.clear();
  ASSERT_TRUE(toy->deactivate());
  toy->throw_in = "activate";
  toy->work.clear();
  const auto broke = toy->activate();
  ASSERT_FALSE(broke);
  EXPECT_EQ(broke.error().outcome, Outcome::kInternal);
  EXPECT_EQ(broke.error().message, "broke in activate");
  EXPECT_EQ(toy->state(), State::kUnconfigured) << "error processing";
  EXPECT_THAT(toy->work, ElementsAre("activate", "deactivate", "cleanup"));
  toy->throw_in.clear();
  EXPECT_TRUE(toy->configure());
}

TEST_F(ManagedComponentTest, ParametersOutliveTheirComponent) {
  ASSERT_TRUE(start({}));
  toy.reset();
  EXPECT_EQ(set("retries", std::int64_t{1}), "") << "nobody is there to object";
}

TEST_F(ManagedComponentTest, DiagnosticsTellTheState) {
  ASSERT_TRUE(start({"autostart:=false", "file:=bad"}));
  EXPECT_FALSE(toy->configure());
  std::vector<diagnostic_msgs::msg::DiagnosticStatus> seen;
  const auto in = node->subscribe<diagnostic_msgs::msg::DiagnosticArray>(
      "/diagnostics", Qos::standard(), [&](const auto& m) { seen = m.status(); });
  ASSERT_TRUE(loop.run_for(3s, [&] { return !seen.empty(); }));
  EXPECT_EQ(seen[0].name(), "toy: state");
  EXPECT_EQ(seen[0].level(), 1);
  EXPECT_EQ(seen[0].message(), "unconfigured: there is no file bad");
}

TEST(ParameterTable, IsOneLineEach) {
  Toy::Params params;
  ParameterSet set;
  Toy::describe(set, params);
  EXPECT_EQ(to_markdown(set),
            "| parameter | type | default | allowed | set | meaning |\n"
            "|---|---|---|---|---|---|\n"
            "| file | string | \"good\" | a file | unconfigured | what to load |\n"
            "| rate | double | 10.0 | 1 .. 100 | unconfigured | how often [Hz] |\n"
            "| mode | string | \"calm\" | calm or wild | unconfigured | how |\n"
            "| fixed | bool | false |  | at start | cannot change |\n"
            "| retries | integer | 3 | 0 .. 9 | any time | tries |\n");
  EXPECT_THAT(to_text(set), HasSubstr("rate (double, default 10.0)"));
}

}  // namespace
}  // namespace goalnet::ros
