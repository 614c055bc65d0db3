"""Playmakers for RoboCup 2D soccer: the wire of cls and a server for it.

>>> from cls_playmaker import Playmaker, proto, start
>>> class Team(Playmaker):
...     def GetPlayerActions(self, state, context):
...         ball = proto.PlayerAction(body_intercept=proto.Body_Intercept())
...         return proto.PlayerActions(actions=[ball], ignore_preprocess=True)
>>> server, port = start(Team())
>>> server.stop(0).wait()
True

A program calls serve(Team()) instead, which reads --port and plays until it is stopped. `proto` has the messages and the service of playmaker.proto.
"""
from cls_playmaker import proto
from cls_playmaker.rows import RowForm, TeamActions, TeamRows
from cls_playmaker.serving import Playmaker, serve, start
from cls_playmaker.states import complete_state

__all__ = ["Playmaker", "RowForm", "TeamActions", "TeamRows", "complete_state", "proto", "serve",
           "start"]
