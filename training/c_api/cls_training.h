// C interface of the training engine: pools of episodes, for any language that can call C.
//
// This header is plain C. It is the only interface of libcls_training.so, whose other symbols are
// hidden. Arrays are contiguous, in C order, and owned by the caller.
//
// A pool holds N worlds. Each world plays one episode after the other of the same task, with A
// agents (rows of the arrays) whose actions the caller chooses. An episode is a pure function of
// configuration, seed and actions: neither threads nor other worlds nor earlier episodes show.
//
//   uint64_t pool;
//   cls_training_create("{\"task\": \"HalfFieldOffense\", \"num_envs\": 64}", &pool);
//   cls_training_spec(pool, text, sizeof text, &length);     // sizes N, A, F, K, V, S, R
//   cls_training_bind(pool, &buffers);                       // once
//   cls_training_reset(pool, NULL, seeds, N);
//   for (...) { fill actions; cls_training_step(pool); read observations, rewards; }
//   cls_training_close(pool);
//
// Every function returns CLS_TRAINING_OK (0) or a negative code; cls_training_error() then has one
// line of text that names the cause. A call that fails has changed nothing, except where stated. No
// exception and no abort crosses the interface. Of two calls for a pool at the same time the second
// returns CLS_TRAINING_BAD_ORDER; different pools may be used in parallel. A child process after
// fork() must create its own pools: inherited ones return CLS_TRAINING_FORKED.
#ifndef CLS_TRAINING_H
#define CLS_TRAINING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define CLS_TRAINING_API __attribute__((visibility("default")))
#else
#define CLS_TRAINING_API
#endif

// Changes when a function, a struct or a meaning below changes.
#define CLS_TRAINING_ABI 4

enum {
  CLS_TRAINING_OK = 0,
  CLS_TRAINING_BAD_POINTER = -1,   // a required pointer is NULL
  CLS_TRAINING_BAD_HANDLE = -2,    // no such pool or snapshot, or it was closed
  CLS_TRAINING_BAD_CONFIG = -3,    // the JSON text, one of its keys or values
  CLS_TRAINING_BAD_SIZE = -4,      // a buffer or array has the wrong number of elements
  CLS_TRAINING_BAD_INDEX = -5,     // no such world
  CLS_TRAINING_BAD_ACTION = -6,    // an action is NaN, infinite or no id of the action set
  CLS_TRAINING_BAD_ORDER = -7,     // step before bind or reset; step of an ended world (see step);
                                   // a call while another thread uses the pool
  CLS_TRAINING_BAD_FILE = -8,      // a recording cannot be written
  CLS_TRAINING_SMALL_BUFFER = -9,  // *length says how many bytes are needed
  CLS_TRAINING_FORKED = -10,       // the pool belongs to the parent process
  CLS_TRAINING_INTERNAL = -11      // out of memory or a defect; the pool should be closed
};

// Values of cls_training_buffers.status: how an episode ended. HFO's names are used where HFO has
// them. "terminated" ends have no future; "truncated" ends should be bootstrapped.
enum {
  CLS_TRAINING_IN_GAME = 0,
  CLS_TRAINING_GOAL = 1,           // terminated: the attacking (left) team scored
  CLS_TRAINING_CAPTURED = 2,       // terminated: the defense has the ball
  CLS_TRAINING_OUT_OF_BOUNDS = 3,  // terminated: the ball left the area of the task
  CLS_TRAINING_OUT_OF_TIME = 4,    // truncated: episode too long or ball untouched too long
  CLS_TRAINING_GOAL_CONCEDED = 5,  // terminated: the right team scored
  CLS_TRAINING_REACHED = 6,        // terminated: the task's aim other than a goal was reached
  CLS_TRAINING_FULL_TIME = 7,      // terminated: the match is over
  CLS_TRAINING_STOPPED = 8         // terminated: the referee stopped play (options.stop_play)
};

// -------------------------------------------------------------------------------- library

// CLS_TRAINING_ABI of the library. Compare it with the header's. 0: the mathematical library inside
// of a packaged file cannot be loaded; cls_training_error() says why, and no pool can be created.
CLS_TRAINING_API int32_t cls_training_abi(void);

// Version of cls, for example "0.1.0". Static storage.
CLS_TRAINING_API const char* cls_training_version(void);

// Text of the last failed call of this thread; empty before one. Valid until its next call. UTF-8,
// one line without a line end.
CLS_TRAINING_API const char* cls_training_error(void);

// Writes the catalog of everything that can be trained as JSON (schema "cls.training.catalog/1"):
//   {"tasks": [{"id", "version", "summary", "options": [{"name", "default", "low", "high",
//               "summary"}], "offense", "defense", "agents", "features", "actions", "referee",
//               "max_cycles"}],
//    "feature_sets": [...], "action_sets": [...], "reward_terms": [...], "statuses": [...]}
// `out` may be NULL if `capacity` is 0. Writes at most `capacity` bytes with a final 0; *length
// becomes the length without it. If it does not fit: CLS_TRAINING_SMALL_BUFFER, call again.
CLS_TRAINING_API int cls_training_catalog(char* out, size_t capacity, size_t* length);

// -------------------------------------------------------------------------------- pool

// Creates a pool from a JSON object (UTF-8). Unknown keys are errors with a suggestion. Keys:
//   "task"        id in the catalog, e.g. "HalfFieldOffense". Required.
//   "num_envs"    N, 1..65536. Default 1.
//   "threads"     threads that step(), 1..256; more than N are not used. Default 1. Results do not
//                 depend on it.
//   "obs"         "full_state" (default): the exact world, without messages; "world_model": what
//                 cls agents estimate from the messages of the server. Scripted players, rewards
//                 and `state` use the exact world with either.
//   "features"    feature set: "hfo_low", "hfo_high", "ego" (version 1), or "team" with the actions
//                 "options"; or with its version, as "ego/2". Default: the task's.
//   "state"       version of the full state, 1 (default) or 2.
//   "actions"     action set: "low", "low_all", "low_flat", "low_discrete", "hfo",
//                 "skills", or "options" with "obs": "world_model". Default: the task's.
//   "offense"     players of the left (attacking) team, where the task lets one choose.
//   "defense"     players of the right team, including its goalie.
//   "agents"      whose actions the caller chooses: "offense" (left), "defense" (right) or "both".
//                 Default: the task's.
//   "num_agents"  how many players of the agents' team the caller controls (the others are
//                 `teammates`). Default: all. The first ones after the goalie, or with
//                 "goalie_agent": true the goalie and the first ones.
//   "teammates"   who plays the players of the agents' team that are not agents, by name: "hold"
//                 (they stand), "scripted" (geometry, from the exact world), "mock" or "planner"
//                 (they perceive and decide as in matches `cls match mock` and `mock:planner`).
//                 Or a pool: {"NAME": weight, ...}, from which each episode draws one for all.
//                 Default: "scripted".
//   "opponent"    the same for the other team, unless "agents" is "both"; also "none": they are not
//                 on the pitch.
//   "autoreset"   "next_step", "same_step" or "disabled" (Gymnasium's modes). Default "disabled".
//   "frame_skip"  cycles per step, 1..100; rewards are summed, an end ends the step. Default 1.
//   "until"       "cycles" (default), or "decision": a step ends before frame_skip cycles when an
//                 agent knows that it can kick the ball, another player has it, or the play mode
//                 has changed; with the actions "options" when it has a choice with the ball
//                 instead of knowing that it can kick it. The actions hold until then; `cycles`
//                 says how many were played.
//   "max_cycles"  length of an episode in cycles; 0: the task's.
//   "reward"      {"TERM": weight, ...}: replaces the task's weights. Terms are in the catalog.
//   "start"       "task" (default): the task places ball and players; "book:FILE": each episode of
//                 Match starts at a situation of a book (docs/formats/book.md) that its seed draws,
//                 with score 0:0 and the types that "types" says.
//   "expert"      "none" (default), or "planner", with the actions "options": `expert` is what the
//                 planner of cls would choose from the agent's own world model.
//   "look"        true: agents choose neck, view and focus; needs "obs": "world_model" and an
//   action
//                 set with ids. Observations then end with what an agent knows of them. Default:
//                 false, neck, view and focus of agents in matches.
//   "say"         true: agents choose what they say, one of eight symbols or nothing; observations
//                 then end with the last symbol that a teammate was heard to say. Default: false.
//   "options"     {"NAME": number, ...}: options of the task, see cls_training_set_options.
//   "types"       "default" (type 0 for all) or "random" (drawn from the seed). Default "default".
// Agents and players: team by team, left first, in the order of the spec's "agents". The own team
// of an agent always attacks +x: features and actions of the right team are mirrored.
CLS_TRAINING_API int cls_training_create(const char* config_json, uint64_t* pool);

// Writes what the pool is as JSON (schema "cls.training.spec/1"), as cls_training_catalog():
//   {"task", "version", "half" (true: played in the right half), "obs", "num_envs", "threads",
//    "num_agents": A, "agents": ["left_11", ...],
//    "features": {"set", "version", "size": F, "items": [{"name", "unit", "low", "high"}, ...]},
//    "actions": {"set", "version", "ids": K, "values": V, "id_low": 0,
//                "items": [{"id", "name", "parameters": [{"name", "unit", "low", "high"}]}],
//                "value_items": [{"name", "unit", "low", "high"}, ...]},
//    "senses": [{"name", "items": [NAME, ...]}, ...],  (H of them: none without look and say)
//    "state": {"size": S, "items": [{"name", "unit", "low", "high"}, ...]},
//    "reward_terms": [{"name", "weight", "summary"}, ...]   (R of them),
//    "teammates": [NAME, ...], "opponents": [NAME, ...], "start",
//    "max_cycles", "frame_skip", "until", "expert", "autoreset", "options": {...}, "statuses":
//    [...]}
// K is 0 for action sets without ids (a box), V is 0 for those without values (discrete ids).
CLS_TRAINING_API int cls_training_spec(uint64_t pool, char* out, size_t capacity, size_t* length);

// Closes the pool and its snapshots; its handle stays invalid forever. Threads have ended and the
// bound buffers are no longer used when it returns. A second call returns CLS_TRAINING_BAD_HANDLE.
CLS_TRAINING_API int cls_training_close(uint64_t pool);

// -------------------------------------------------------------------------------- buffers

// `count` is the number of elements and must be exactly the product of the shape.
typedef struct {
  void* data;
  uint64_t count;
} cls_training_buffer;

// Arrays that step() and reset() read and write. Those marked (needed) must be given; in the others
// `data` may be NULL, and they are not filled then. They must stay valid until the next bind() or
// close(). Alignment: that of the element type.
typedef struct {
  uint64_t struct_size;  // sizeof(cls_training_buffers)

  // In: read by step(). Give the ones of the action set: `action_ids` if K > 0, `action_values` if
  // V > 0. Rows of agents that are not alive are ignored.
  cls_training_buffer action_ids;     // int32 [N, A], 0..K-1; with senses [N, A, 1 + H]: the id,
                                      // then the number of an item of each of them
  cls_training_buffer action_values;  // float32 [N, A, V]; clipped to the bounds in the spec
  // In: seed of a world's next automatic reset; needed unless autoreset is disabled. Renew the
  // entries of worlds with was_reset != 0 after each step.
  cls_training_buffer next_seeds;  // uint64 [N]

  // Out.
  cls_training_buffer observations;  // float32 [N, A, F] (needed)
  cls_training_buffer rewards;       // float32 [N, A] (needed)
  cls_training_buffer terminated;    // uint8 [N] (needed): 1 in the step in which the episode ended
  cls_training_buffer truncated;     // uint8 [N] (needed)
  cls_training_buffer status;        // int32 [N] (needed): CLS_TRAINING_IN_GAME ...
  cls_training_buffer alive;         // uint8 [N, A]: 0 after a red card; its observation is zeros
  cls_training_buffer action_masks;  // uint8 [N, A, K]: 1 where an id has an effect now
  cls_training_buffer state;         // float32 [N, S]: the full state, left team's view
  cls_training_buffer reward_terms;  // float32 [N, R]: unweighted terms of this step (left view)
  cls_training_buffer final_observations;  // float32 [N, A, F]: same_step only, where was_reset
  cls_training_buffer final_state;         // float32 [N, S]: same
  cls_training_buffer was_reset;           // uint8 [N]: 1 if this step (or reset) began an episode
  cls_training_buffer cycles;    // int32 [N]: cycles of the episode so far (of the ended one)
  cls_training_buffer score;     // int32 [N, 2]: left, right
  cls_training_buffer illegal;   // int32 [N, A]: illegal actions of the episode so far
  cls_training_buffer seeds;     // uint64 [N]: seed of the running episode
  cls_training_buffer opponent;  // int32 [N]: the opponents of the episode, an index in the spec's
                                 // "opponents"; -1: none, or agents on both teams
  cls_training_buffer expert;    // int32 [N, A] with "expert", otherwise empty: the id that the
                                 // expert would choose for the agent; -1: nothing to choose
} cls_training_buffers;

// Binds the arrays; replaces earlier ones. Nothing is written until the next reset or step.
CLS_TRAINING_API int cls_training_bind(uint64_t pool, const cls_training_buffers* buffers);

// -------------------------------------------------------------------------------- playing

// Starts new episodes in the worlds with mask[i] != 0 (NULL: all) with seeds[i], and fills their
// rows: first observation, reward 0, status IN_GAME, was_reset 1. Other rows keep their values,
// except was_reset 0. `count` is N and the number of elements of `mask` and `seeds`.
CLS_TRAINING_API int cls_training_reset(uint64_t pool, const uint8_t* mask, const uint64_t* seeds,
                                        uint64_t count);

// Plays one step (frame_skip cycles) of every world with the bound actions and fills all rows.
// Actions are checked first: a bad one gives CLS_TRAINING_BAD_ACTION and no world has moved. An id
// that is masked out acts as "no action" and counts in `illegal`. An episode that ended in the step
// before:
//   disabled    the world stands still: its rows keep observation and status, with reward 0 and
//               terminated/truncated as they were. Reset it with cls_training_reset(). If all
//               worlds have ended: CLS_TRAINING_BAD_ORDER.
//   next_step   this step resets it with next_seeds[i]: the action is ignored, the row is that of
//               a reset.
//   same_step   does not occur: the world was reset in the step in which it ended. `observations`
//               and `state` are then those of the new episode, `final_*` those of the old; rewards,
//               terminated, truncated, status, cycles, score, illegal and reward_terms are those of
//               the old episode. `seeds` and `opponent` are the new episode's.
CLS_TRAINING_API int cls_training_step(uint64_t pool);

// Sets options of the task ({"NAME": number, ...}, names in the catalog) for world `env`, or for
// all worlds if it is -1. They hold from the next reset of the world on. "difficulty" 0..1 exists
// in every task: 0 places the ball and the players for the easiest start, 1 is the task itself.
CLS_TRAINING_API int cls_training_set_options(uint64_t pool, int64_t env, const char* options_json);

// -------------------------------------------------------------------------------- copies

// Stores the whole episode of a world (physics, random streams, rules) and returns its handle.
CLS_TRAINING_API int cls_training_snapshot(uint64_t pool, uint64_t env, uint64_t* snapshot);

// Puts a snapshot of the same pool into world `env` and fills the row as a step would: observation,
// masks, state, status, cycles, score; rewards 0. The same actions then give the same results. May
// be called many times.
CLS_TRAINING_API int cls_training_restore(uint64_t pool, uint64_t env, uint64_t snapshot);

// Releases a snapshot.
CLS_TRAINING_API int cls_training_release(uint64_t pool, uint64_t snapshot);

// Copies the episode of world `from` into world `to`: restore without a handle.
CLS_TRAINING_API int cls_training_fork(uint64_t pool, uint64_t from, uint64_t to);

// -------------------------------------------------------------------------------- watching

// Records the next episode of a world, from its next reset to its end, as a game log (rcg version
// 6) in `path`; if that ends in .rcg or .rcg.gz, also its commands as a text log, in the file with
// .rcl instead. The files are written when the episode ends, when the world is reset or at close().
// Names that end in .gz are compressed. NULL: stops and forgets a recording. An error of writing is
// the result of the call that ended the episode, which is complete otherwise.
CLS_TRAINING_API int cls_training_record(uint64_t pool, uint64_t env, const char* path);

typedef struct {
  int32_t side;  // 1 left, -1 right
  int32_t unum;
  int32_t on_pitch;  // 0: not part of the episode, or sent off
  int32_t goalie;
  double x, y;           // meters, server coordinates: left defends x = -52.5, y grows downwards
  double vx, vy;         // meters per cycle
  double body, neck;     // degrees; neck relative to body
  double stamina;        // 0..8000
  double kickable_area;  // meters; set_state ignores it
  double effort, recovery;
  double capacity;  // of stamina
  // Cycles for which its tackle, a foul that it suffered or a catch block it; yellow cards.
  int32_t tackle_cycles, foul_cycles, catch_ban, cards;
  int32_t type;  // its player type
  int32_t reserved;
} cls_training_player;

typedef struct {
  uint64_t struct_size;  // in: sizeof(cls_training_world)
  uint64_t seed;
  int32_t cycle;       // of the episode
  int32_t time;        // of the match clock
  int32_t score[2];    // left, right
  int32_t status;      // CLS_TRAINING_IN_GAME ...; set_state ignores it
  char play_mode[32];  // "play_on"
  double ball_x, ball_y, ball_vx, ball_vy;
  int32_t last_touch;               // index of the player that touched the ball last; -1: none
  int32_t catcher;                  // index of the goalie that holds the ball; -1: none
  cls_training_player players[22];  // left 1..11, right 1..11
} cls_training_world;

// Copies the physical state of a world.
CLS_TRAINING_API int cls_training_view(uint64_t pool, uint64_t env, cls_training_world* world);

// Starts an episode in world `env` from a physical state and fills the row as a reset does: with
// the seed, the cycle of the episode, the clock, the score, the play mode, the ball and the players
// of `world`, which cls_training_view() then returns (angles to rounding). It is the state of the
// bodies alone, unlike a snapshot: random streams begin with the seed, a set play begins anew, and
// agents that perceive know what they see in it. Players who do not play in the task are ignored.
// CLS_TRAINING_BAD_CONFIG: an episode cannot start there; the text names the field.
CLS_TRAINING_API int cls_training_set_state(uint64_t pool, uint64_t env,
                                            const cls_training_world* world);

#ifdef __cplusplus
}
#endif

#endif
