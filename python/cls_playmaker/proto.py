"""The messages, enumeration values and service of playmaker.proto, under one name.

`proto.State`, `proto.PlayerAction`, `proto.PlayOn`, `proto.GameServicer`, `proto.GameStub`, ...
The comments of playmaker.proto give their meaning and units.
"""
from cls_playmaker.playmaker_pb2 import *  # noqa: F401,F403
from cls_playmaker.playmaker_pb2 import DESCRIPTOR  # noqa: F401
from cls_playmaker.playmaker_pb2_grpc import (  # noqa: F401
    GameServicer, GameStub, add_GameServicer_to_server)
