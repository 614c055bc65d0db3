#!/usr/bin/env python3
"""The team in Python: serves decide.py on the package cls_playmaker.

    ./run --port 50051 --coach         generates the messages of the wire, then starts this program
    cls match mock localhost:50051
"""
import argparse
import os
import sys

# Without ./run: the package of a built checkout. Elsewhere it must be installed (pip install ./python).
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../build/python"))
from cls_playmaker import Playmaker, proto as pb, serve  # noqa: E402

import decide  # noqa: E402


class Team(Playmaker):
    lean_states = True  # decide.py does not read the dictionaries of players

    def __init__(self, coach):
        self.coach = coach

    def GetPlayerActions(self, state, context):
        return decide.decide(state)

    def GetCoachActions(self, state, context):
        if not self.coach:
            return super().GetCoachActions(state, context)  # UNIMPLEMENTED: plays without coach
        return decide.decide_as_coach(state)

    def GetTrainerActions(self, state, context):
        return decide.decide_as_trainer(state)

    def GetBestPlannerAction(self, request, context):
        """The node with the highest value; the lowest index among equal ones."""
        best = min(request.pairs, key=lambda index: (-request.pairs[index].evaluation, index),
                   default=-1)
        return pb.BestPlannerActionResponse(index=best)


def main():
    parser = argparse.ArgumentParser(description="The example team of cls.")
    parser.add_argument("--port", type=int, default=50051,
                        help="listening port; 0 selects a free one (default: 50051)")
    parser.add_argument("--coach", action="store_true", help="decide for the coach, too")
    options = parser.parse_args()
    serve(Team(options.coach), options.port)


if __name__ == "__main__":
    main()
