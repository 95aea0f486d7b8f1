// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Senders and receivers over networks that lose, delay and double messages, killed and started again: at no
// moment a crack, and in the end the sender's map. DELTAMESH_MAP_SCHEDULES: how many schedules, of 10,000;
// DELTAMESH_MAP_FIRST_SCHEDULE: the number of the first.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "deltamesh/map/folder.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"
#include "map/map_world.h"
#include "part/fitness.h"
#include "part/view_cells.h"

namespace deltamesh {
namespace {

namespace fs = std::filesystem;
using test::Square;
using test::World;
using Bytes = std::vector<std::byte>;

constexpr double kTick = 0.1;
constexpr int kChangingTicks = 40;
constexpr int kMostTicks = 1500;

/// What a receiver has saved.
struct Saved {
  std::vector<PartEntry> entries;
  std::vector<Bytes> octets;
  std::optional<MapDescription> description;
};

struct Client {
  std::unique_ptr<MapReceiver> receiver;
  std::uint64_t viewer = 0;
  Saved saved;
  std::set<Square> covered;
};

struct Letter {
  double arrives = 0;
  int to = -1;  ///< a client, or -1: the sender
  Bytes bytes;
};

class Schedule {
 public:
  explicit Schedule(std::uint32_t seed) : random_(seed), world_(3 + static_cast<int>(seed % 3), seed) {
    if (seed / 8 % 8 == 0)
      folder_ = (fs::temp_directory_path() / ("deltamesh_simulation_" + std::to_string(::getpid()))).string();
    loss_ = 0.3 * unit();
    options_.effort = 0;
    options_.geometry = GeometryCoder::kPredictive;
    options_.split.most_triangles = 1U << (random_() % 4);
    if (random_() % 2 == 0) {  // with coarser copies
      options_.split.most_level = 1;
      options_.split.copy_level = static_cast<std::uint8_t>(2 + random_() % 2);
    }
    options_.keeps_good_enough = random_() % 2 == 0;
    start_sender();
    clients_.resize(1 + random_() % 3);
  }

  ~Schedule() {
    std::error_code ignored;
    if (!folder_.empty()) fs::remove_all(folder_, ignored);
  }
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;

  void run() {
    for (int tick = 0; tick < kMostTicks && !failed_; ++tick) {
      now_ = kTick * tick;
      const bool is_changing = tick < kChangingTicks;
      if (is_changing) disturb(tick);
      for (std::size_t i = 0; i < clients_.size(); ++i) talk(static_cast<int>(i), tick);
      deliver();
      if (is_changing || tick % 10 != 0) continue;
      // What the rate holds back may still be to come.
      settled_ = is_settled() ? settled_ + 1 : 0;
      if (settled_ == 3) return check_end();
    }
    if (!failed_) ADD_FAILURE() << "has not settled";
  }

  /// By the last sender.
  std::uint64_t patches_sent() const { return sender_->counts().patches_sent; }

 private:
  double unit() { return static_cast<double>(random_() % 10000) / 10000; }

  void start_sender() {
    if (sender_ && !folder_.empty()) {
      const auto manifest = load_map(folder_ + "/sender");
      ASSERT_TRUE(manifest);
      description_ = manifest->description;
      saved_revision_ = manifest->revision;
      saved_group_ = manifest->next_group;
      if (random_() % 2 == 0) begin_epoch();
    }
    auto sender = MapSender::make(description_, options_);
    ASSERT_TRUE(sender);
    sender_ = std::make_unique<MapSender>(std::move(*sender));
    sender_->resume(saved_revision_, saved_group_);
    sender_start_ = sender_->revision();
    heard_.clear();
    tell(world_.present());
  }

  /// Starting states from what the map has become.
  void begin_epoch() {
    std::vector<MapPart> parts;
    for (const PartKey& key : sender_->keys()) parts.push_back(*sender_->source(key));
    ++description_.epoch;
    auto renewed =
        with_primers(description_, parts, {.bounds = {.max_error = QualityBound{0.1}}, .effort = 0});
    ASSERT_TRUE(renewed);
    description_ = *std::move(renewed);
  }

  void tell(const std::set<Square>& squares) {
    ASSERT_TRUE(world_.tell(*sender_, squares));
    saved_revision_ = sender_->revision();
    saved_group_ = sender_->next_group();
    if (folder_.empty()) return;
    const MapManifest manifest{
        .description = description_, .revision = saved_revision_, .next_group = saved_group_};
    ASSERT_TRUE(save_map(folder_ + "/sender", manifest, {}));
  }

  void disturb(int tick) {
    if (tick % 3 == 0) tell(world_.change());
    if (random_() % 60 == 0) start_sender();
    Client& client = clients_[random_() % clients_.size()];
    if (!client.receiver) {
      if (random_() % 4 == 0) start(client);
    } else if (random_() % 20 == 0) {
      client.receiver->set_view(random_view());
      client.covered.clear();  // what was out of the view may have gone
    } else if (random_() % 15 == 0) {
      save(client);
    } else if (random_() % 25 == 0) {
      start(client);
    }
  }

  View random_view() {
    View view;
    if (random_() % 2 == 0) {
      const auto x = static_cast<float>(random_() % 4);
      const auto y = static_cast<float>(random_() % 4);
      view.boxes = {{{x + 0.1F, y + 0.1F, -1}, {x + 1.9F, y + 1.9F, 2}}};
    }
    // What is finer than asked for stays, so that only receivers of one quality end alike.
    view.max_error = options_.keeps_good_enough && random_() % 2 == 0 ? 0.02F : 0.1F;
    view.bytes_per_second = random_() % 3 == 0 ? 2000 : 0;
    if (options_.split.copy_level > 0 && random_() % 4 == 0)
      view.level = static_cast<std::uint8_t>(random_() % 3);
    return view;
  }

  void save(Client& client) {
    client.saved = {};
    if (client.receiver->description() == nullptr) return;
    client.saved.description = *client.receiver->description();
    for (const HeldPart& part : client.receiver->held()) {
      client.saved.entries.push_back(part.entry);
      client.saved.octets.emplace_back(part.octets.begin(), part.octets.end());
    }
    if (!folder_.empty()) save_to_folder(client);
  }

  std::string folder_of(const Client& client) const {
    return folder_ + "/client_" + std::to_string(&client - clients_.data());
  }

  void save_to_folder(const Client& client) {
    MapManifest manifest{
        .description = *client.saved.description, .next_group = 1, .entries = client.saved.entries};
    std::vector<NewPart> parts;
    for (std::size_t i = 0; i < manifest.entries.size(); ++i) {
      const PartEntry& entry = manifest.entries[i];
      manifest.revision = std::max(manifest.revision, entry.revision);
      manifest.next_group = std::max(manifest.next_group, entry.group + 1);
      parts.push_back({entry.key, entry.revision, client.saved.octets[i]});
    }
    const auto saved = save_map(folder_of(client), manifest, parts);
    ASSERT_TRUE(saved) << describe(saved.error());
  }

  void load_from_folder(Client& client) {
    const auto manifest = load_map(folder_of(client));
    ASSERT_TRUE(manifest);
    client.saved = {manifest->entries, {}, manifest->description};
    for (const PartEntry& entry : manifest->entries) {
      auto octets = load_part(folder_of(client), entry);
      ASSERT_TRUE(octets);
      client.saved.octets.push_back(*std::move(octets));
    }
  }

  /// From what was saved, with a new connection.
  void start(Client& client) {
    const int number = static_cast<int>(&client - clients_.data());
    std::erase_if(letters_, [&](const Letter& letter) { return letter.to == number; });
    const View view = client.receiver ? client.receiver->view() : random_view();
    client.viewer = ++last_viewer_;
    client.receiver = std::make_unique<MapReceiver>(client.viewer, World::description().id);
    client.receiver->set_view(view);
    client.covered.clear();
    if (!client.saved.description) return;
    if (!folder_.empty()) load_from_folder(client);
    EXPECT_TRUE(client.receiver->apply(*write_description(*client.saved.description)));
    for (std::size_t i = 0; i < client.saved.entries.size(); ++i) {
      // What was made in an earlier epoch comes again.
      const auto restored = client.receiver->restore(client.saved.entries[i], client.saved.octets[i]);
      EXPECT_TRUE(restored || (!folder_.empty() && restored.error().code == ErrorCode::kCorrupt));
      check(client);
    }
  }

  void post(int to, const Bytes& bytes) {
    if (unit() < loss_) return;
    for (int copies = random_() % 10 == 0 ? 2 : 1; copies > 0; --copies)
      letters_.push_back({now_ + unit() * (random_() % 5 == 0 ? 1.5 : 0.2), to, bytes});
  }

  void talk(int number, int tick) {
    const Client& client = clients_[static_cast<std::size_t>(number)];
    if (!client.receiver) return;
    if (number % 2 == 0) {  // at times of its own
      if ((tick + number) % 4 == 0) post(-1, *client.receiver->view_message());
    } else {
      const auto said = client.receiver->messages(now_);
      ASSERT_TRUE(said);
      for (const Bytes& message : *said) post(-1, message);
    }
    if (!is_viewer(client)) return;
    const auto messages = sender_->messages_for(client.viewer, now_);
    ASSERT_TRUE(messages) << describe(messages.error());
    for (const Bytes& message : *messages) post(number, message);
  }

  void deliver() {
    std::vector<Letter> later;
    for (Letter& letter : std::exchange(letters_, {})) {
      if (letter.arrives > now_) {
        later.push_back(std::move(letter));
      } else if (letter.to < 0) {
        EXPECT_TRUE(sender_->hear(letter.bytes, now_));
        if (const auto told = read_view(letter.bytes)) heard_[told->viewer] = *told;
      } else if (Client& client = clients_[static_cast<std::size_t>(letter.to)]; client.receiver) {
        // Refused is what comes before the map's message.
        const auto applied = client.receiver->apply(letter.bytes);
        EXPECT_TRUE(applied || applied.error().code == ErrorCode::kInvalidArgument);
        check(client);
      }
    }
    later.insert(later.end(), std::make_move_iterator(letters_.begin()),
                 std::make_move_iterator(letters_.end()));
    letters_ = std::move(later);
  }

  /// No crack, no cell twice, no hole where a part was replaced.
  void check(Client& client) {
    const MapReceiver& receiver = *client.receiver;
    std::map<std::pair<float, float>, float> heights;
    std::set<Square> covered;
    const auto keys = receiver.shown();
    for (const PartKey& key : keys) {
      const MapPart& part = *receiver.find(key);
      for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) {
        const float* p = &part.mesh.positions[3 * v];
        const std::pair corner(std::round(p[0]), std::round(p[1]));
        const float height = heights.try_emplace(corner, p[2]).first->second;
        if (height != p[2]) fail("a crack");
      }
      for (std::size_t f = 0; f < part.mesh.triangle_count(); ++f) {
        Square square{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
          float sum = 0;
          for (std::size_t c = 0; c < 3; ++c)
            sum += part.mesh.positions[3 * std::size_t{part.mesh.triangles[3 * f + c]} + axis];
          square[axis] = static_cast<std::int32_t>(std::floor(sum / 3));
        }
        covered.insert(square);
      }
      for (const PartKey& other : keys)
        if (other != key && overlap(key, other)) fail("two parts in one place");
    }
    if (receiver.view().boxes.empty() && options_.split.copy_level == 0)
      for (const Square& square : client.covered)
        if (!covered.contains(square) && !world_.ever_removed().contains(square)) fail("a hole");
    client.covered = std::move(covered);
  }

  void fail(const char* what) {
    if (!failed_) ADD_FAILURE() << what << " at " << now_;
    failed_ = true;
  }

  bool is_viewer(const Client& client) const {
    const auto viewers = sender_->viewers();
    return std::ranges::find(viewers, client.viewer) != viewers.end();
  }

  /// Whether the sender knows what the client asks for, and the client takes what it sends.
  bool is_in_touch(const Client& client) const {
    const auto heard = heard_.find(client.viewer);
    return heard != heard_.end() && heard->second.start >= sender_start_ &&
           heard->second.view == client.receiver->view();
  }

  std::map<PartKey, std::uint64_t> believed(const Client& client) const {
    std::map<PartKey, std::uint64_t> hashes;
    for (const PartEntry& entry : sender_->entries_of(client.viewer))
      if (is_in_view(entry.key, client.receiver->view(), World::description()))
        hashes[entry.key] = entry.hash;
    return hashes;
  }

  std::map<PartKey, std::uint64_t> shown(const Client& client) const {
    std::map<PartKey, std::uint64_t> hashes;
    for (const HeldPart& part : client.receiver->held())
      if (is_in_view(part.entry.key, client.receiver->view(), World::description()))
        hashes[part.entry.key] = part.entry.hash;
    return hashes;
  }

  /// The parts that show what of the map is in a view, on its level: of copies not those of other places.
  std::vector<PartKey> wanted_in(const View& view) const {
    const auto keys = sender_->keys();
    std::vector<PartKey> seen;
    for (const PartKey& key : keys_on_level(keys, 0))
      if (is_in_view(ancestor(key, std::max(key.level, view.level)), view, World::description()))
        seen.push_back(key);
    std::vector<PartKey> wanted;
    for (const PartKey& key : keys)
      if (is_in_view(key, view, World::description()) &&
          std::ranges::any_of(seen, [&](const PartKey& other) { return overlap(key, other); }))
        wanted.push_back(key);
    return keys_on_level(wanted, 0);
  }

  bool is_settled() {
    for (Client& client : clients_) {
      if (!client.receiver) start(client);
      if (!is_in_touch(client)) return false;
      if (client.receiver->description() == nullptr || believed(client) != shown(client)) return false;
      const std::vector<PartKey> wanted = wanted_in(client.receiver->view());
      const auto have = shown(client);
      if (wanted.size() != have.size()) return false;
      for (const PartKey& key : wanted) {
        if (!have.contains(key)) return false;
        if (errors_between(sender_->source(key)->mesh, client.receiver->find(key)->mesh).max_error >
            *client.receiver->view().max_error + 1e-6)
          return false;
      }
    }
    return true;
  }

  /// Who joins last, over a network without faults, has the same.
  void check_end() {
    for (Client& client : clients_) {
      if (options_.keeps_good_enough) continue;
      MapReceiver fresh(++last_viewer_, World::description().id);
      View view = client.receiver->view();
      view.bytes_per_second = 0;
      fresh.set_view(view);
      for (int i = 0; i < 8; ++i) {
        ASSERT_TRUE(sender_->hear(*fresh.view_message(), now_ + i));
        const auto messages = sender_->messages_for(last_viewer_, now_ + i);
        ASSERT_TRUE(messages);
        for (const Bytes& message : *messages) ASSERT_TRUE(fresh.apply(message));
      }
      std::map<PartKey, std::uint64_t> hashes;
      for (const HeldPart& part : fresh.held()) hashes[part.entry.key] = part.entry.hash;
      EXPECT_EQ(hashes, shown(client));
      if (view.boxes.empty() && view.level == 0) {
        EXPECT_EQ(fresh.hash(), client.receiver->hash());
      }
    }
  }

  std::mt19937 random_;
  World world_;
  double loss_ = 0;
  SenderOptions options_;
  std::string folder_;  ///< where states are kept; empty: in memory
  MapDescription description_ = World::description();
  std::unique_ptr<MapSender> sender_;
  std::uint64_t sender_start_ = 0;
  std::map<std::uint64_t, ViewMessage> heard_;  ///< the last of each viewer, by the present sender
  std::uint64_t saved_revision_ = 0;
  std::uint64_t saved_group_ = 0;
  std::vector<Client> clients_;
  std::uint64_t last_viewer_ = 0;
  std::vector<Letter> letters_;
  double now_ = 0;
  bool failed_ = false;
  int settled_ = 0;
};

std::uint32_t number_in(const char* variable, std::uint32_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
}

/// Of all schedules every eighth, so that ctest can run them side by side.
class MapSimulation : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(MapSimulation, MAP12NeverACrackAndInTheEndTheSendersMap) {
  const std::uint32_t first = number_in("DELTAMESH_MAP_FIRST_SCHEDULE", 0);
  const std::uint32_t count = number_in("DELTAMESH_MAP_SCHEDULES", 10'000);
  std::uint64_t patches = 0;
  for (std::uint32_t i = GetParam(); i < count; i += 8) {
    SCOPED_TRACE("schedule " + std::to_string(first + i));
    Schedule schedule(first + i);
    schedule.run();
    patches += schedule.patches_sent();
    if (HasFailure()) break;
  }
  EXPECT_TRUE(patches > 0 || count < 200);
}

INSTANTIATE_TEST_SUITE_P(EveryEighth, MapSimulation, ::testing::Range(0U, 8U));

}  // namespace
}  // namespace deltamesh
