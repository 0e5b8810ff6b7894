#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "files/files.h"
#include "tests/environment_variables.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/training/ranks.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

TrainOptions options() {
  TrainOptions o;
  o.reduction.width = 48;
  o.epochs = 2;
  o.batch_size = 4;
  o.batches_per_step = 2;
  o.dropout = .25;
  o.ema_decay = .9;
  o.augmentation.probability = .3;
  o.threads = 1;
  return o;
}

/// Five batches an epoch: the last step of two has one.
Dataset streets(const std::filesystem::path& folder) {
  return make_street_dataset(folder, {.sizes = {{96, 54}},
                                      .fields_of_view = 3,
                                      .lenses_per_part = 2,
                                      .train_places = 3,
                                      .val_places = 1,
                                      .test_places = 1});
}

int free_port() {
  const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address);
  getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &length);
  close(descriptor);
  return ntohs(address.sin_port);
}

}  // namespace

// The test below runs this case in two processes at once.
TEST_CASE("one process of two", "[.rank-worker]") {
  REQUIRE(std::getenv("CPS_TEST_FOLDER"));
  const std::filesystem::path folder = std::getenv("CPS_TEST_FOLDER");
  const Ranks ranks = join_ranks();
  REQUIRE(ranks.count == 2);
  CHECK(ranks.sum(ranks.rank + 1.0) == 3);
  train(read_dataset(folder / "data"), folder / "two", options(), false, {}, ranks);
}

TEST_CASE("two processes on the loopback give the same weights as one") {
  const TemporaryFolder folder;
  const Dataset dataset = streets(folder.path / "data");
  train(dataset, folder.path / "one", options(), false, {});
  const std::string program = std::filesystem::read_symlink("/proc/self/exe"),
                    environment =
                        "CPS_TEST_FOLDER=" + folder.path.string() +
                        " WORLD_SIZE=2 MASTER_ADDR=127.0.0.1 MASTER_PORT=" + std::to_string(free_port()) +
                        " ",
                    log = " > " + folder.path.string() + "/log";
  const std::string command = environment + "RANK=1 " + program + " '[.rank-worker]'" + log + "1 2>&1 & " +
                              environment + "RANK=0 " + program + " '[.rank-worker]'" + log +
                              "0 2>&1; first=$?; wait $! && exit $first";
  const int status = std::system(command.c_str());
  INFO(read_file(folder.path / "log0") << read_file(folder.path / "log1"));
  REQUIRE(status == 0);
  const bool is_equal =
      read_file(folder.path / "one/weights.pt") == read_file(folder.path / "two/weights.pt");
  CHECK(is_equal);
}

TEST_CASE("batches of one step are averaged, not summed") {
  const TemporaryFolder folder;
  const Dataset dataset = streets(folder.path / "data");
  TrainOptions many = options();
  many.batches_per_step = 100;  // all of an epoch
  const TrainSummary summary = train(dataset, folder.path / "many", many, false, {});
  CHECK(summary.epochs.size() == 2);
  CHECK(summary.epochs[0].training_loss == Approx(1).epsilon(.05));  // one step, from the mean's error
}

TEST_CASE("an invalid environment is refused in one line") {
  CHECK(join_ranks().count == 1);
  {
    const EnvironmentVariables v{{"WORLD_SIZE", "2"}, {"RANK", "0"}};
    CHECK_THROWS_WITH(join_ranks(), Catch::StartsWith("MASTER_ADDR: is not set"));
  }
  {
    const EnvironmentVariables v{{"WORLD_SIZE", "2"}, {"RANK", "2"}, {"MASTER_ADDR", "127.0.0.1"}};
    CHECK_THROWS_WITH(join_ranks(), Catch::StartsWith("RANK: must be a whole number from 0 to 1"));
  }
  {  // a job's script, not a step of it
    const EnvironmentVariables v{{"SLURM_NTASKS", "2"}, {"SLURM_PROCID", "0"}};
    CHECK(join_ranks().count == 1);
  }
  {
    const EnvironmentVariables v{{"SLURM_STEP_NUM_TASKS", "two"}};
    CHECK_THROWS_WITH(join_ranks(), Catch::StartsWith("WORLD_SIZE: "));
  }
}
