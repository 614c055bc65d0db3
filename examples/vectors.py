#!/usr/bin/env python3
"""Writes the test vectors of the example team: States of recorded matches, and the Python team's
replies to them. Tests in every language read both files and expect the same replies.

    cls match 'run:examples/python/run --port {port} --coach' mock --cycles 600 --record-rpc a.rpc
    PYTHONPATH=examples/python/.build examples/vectors.py a.rpc

fixtures/team/states.bin is one GetTeamActionsRequest, replies.bin the GetTeamActionsResponse
(proto/team_playmaker.proto).
"""
import collections
import gzip
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, "python"))
from google.protobuf.internal.decoder import _DecodeVarint32  # noqa: E402
from cls_playmaker import proto as pb  # noqa: E402
from cls_playmaker import team_playmaker_pb2 as wire  # noqa: E402

import decide  # noqa: E402

FOLDER = os.path.join(HERE, "../fixtures/team")
PER_KIND = 5  # States for each sequence of actions that occurs in a reply
COACH, TRAINER = 12, 13
DECISIONS = {COACH: decide.decide_as_coach, TRAINER: decide.decide_as_trainer}


def recorded_states(path):
    """(agent, State) of each decision in a file that --record-rpc wrote."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["protoc", "-I", os.path.join(HERE, "../proto"), f"--python_out={folder}",
                        "rpc_recording.proto"], check=True)
        sys.path.append(folder)
        import rpc_recording_pb2 as recording
    with gzip.open(path) as file:
        data = file.read()
    size, at = _DecodeVarint32(data, 0)
    at += size  # the header
    while at < len(data):
        size, at = _DecodeVarint32(data, at)
        call = recording.RecordedCall.FromString(data[at:at + size])
        at += size
        if call.side == 1 and call.rpc in ("GetPlayerActions", "GetCoachActions"):
            yield call.agent, pb.State.FromString(call.request)


def kind(agent, reply):
    """What is tried in which order; of players with the ball by half, too."""
    return (agent > 11,) + tuple(action.WhichOneof("action") for action in reply.actions)


def select(paths):
    """Few States of each kind, spread over the matches; then those that a match rarely has."""
    by_kind = collections.defaultdict(list)
    for path in paths:
        for agent, state in recorded_states(path):
            by_kind[kind(agent, DECISIONS.get(agent, decide.decide)(state))].append((agent, state))
    chosen = []
    for found in by_kind.values():
        step = max(1, len(found) // PER_KIND)
        chosen += found[::step][:PER_KIND]
    _, field_player = next(one for one in chosen if one[0] == 9)
    penalty = pb.State.FromString(field_player.SerializeToString())
    penalty.world_model.is_penalty_kick_mode = True
    tired = pb.State.FromString(field_player.SerializeToString())
    tired.world_model.self.stamina = 3000.0
    trainer = pb.State.FromString(next(state for agent, state in chosen if agent == COACH)
                                  .SerializeToString())
    return chosen + [(9, penalty), (9, tired), (TRAINER, trainer)]


def main():
    request, response = wire.GetTeamActionsRequest(), wire.GetTeamActionsResponse()
    for agent, state in select(sys.argv[1:]):
        reply = DECISIONS.get(agent, decide.decide)(state)
        request.agents.add(agent=agent, message=state.SerializeToString(deterministic=True))
        response.agents.add(agent=agent, message=reply.SerializeToString())
    for name, message in (("states.bin", request), ("replies.bin", response)):
        with open(os.path.join(FOLDER, name), "wb") as file:
            file.write(message.SerializeToString())
    print(len(request.agents), "States")


if __name__ == "__main__":
    main()
