"""Serves TeamPlaymaker of team_playmaker.proto: the calls of a team's agents in one call."""
from __future__ import annotations

from typing import Any, Dict, Optional

import grpc

from cls_playmaker import proto
from cls_playmaker import team_playmaker_pb2 as wire
from cls_playmaker import team_playmaker_pb2_grpc as service
from cls_playmaker.errors import Errors, Failure
from cls_playmaker.rows import TeamActions, TeamRows

_VERSION = 1
_OTHER_DECISIONS = {12: "GetCoachActions", 13: "GetTrainerActions"}


class TeamServicer(service.TeamPlaymakerServicer):
    """Takes each call apart and calls the Playmaker's methods, one agent after the other.

    What fails for one agent concerns the reply to that agent alone.
    """

    def __init__(self, playmaker: proto.GameServicer, errors: Errors) -> None:
        self._playmaker = playmaker
        self._errors = errors

    def RegisterTeam(self, request: wire.RegisterTeamRequest,
                     context: Any) -> wire.RegisterTeamResponse:
        response = wire.RegisterTeamResponse(version=_VERSION)
        if getattr(self._playmaker, "lean_states", False) and wire.LEAN_STATES in request.encodings:
            response.encoding = wire.LEAN_STATES
        refusal = self._refusal(request)
        if refusal:
            refused = Failure(grpc.StatusCode.FAILED_PRECONDITION, refusal)
            response.agents.extend(_failed(one.agent, refused) for one in request.agents)
            return response
        self._choose_rows(request, response)
        for one in request.agents:
            registration = proto.RegisterRequest.FromString(one.message)
            reply = self._reply(one.agent, "Register", registration, context)
            response.agents.append(reply)
            if reply.code == 0:
                identity = proto.RegisterResponse.FromString(reply.message)
                self._introduce(one.agent, identity, request, context)
        return response

    def _refusal(self, request: wire.RegisterTeamRequest) -> str:
        """Why the Playmaker does not play with this request; empty: it does."""
        refusal: str = getattr(self._playmaker, "refuses", lambda rated: "")(request.rated)
        form = getattr(self._playmaker, "row_form", None)
        if refusal or form is None:
            return refusal
        for wanted, offered in ((form.feature_set, request.feature_sets),
                                (form.action_set, request.action_sets)):
            if wanted not in offered:
                return f"needs {wanted}; the match has {', '.join(offered) or 'no such form'}"
        return ""

    def _choose_rows(self, request: wire.RegisterTeamRequest,
                     response: wire.RegisterTeamResponse) -> None:
        form = getattr(self._playmaker, "row_form", None)
        if form is None:
            return
        response.encoding = wire.TENSOR
        response.feature_set, response.action_set = form.feature_set, form.action_set
        response.teammates, response.opponents = form.teammates, form.opponents

    def _decide_rows(self, request: wire.GetTeamActionsRequest,
                     context: Any) -> wire.GetTeamActionsResponse:
        players = [one.agent for one in request.agents if one.agent not in _OTHER_DECISIONS]
        rows = TeamRows(request.cycle, request.play_mode, players, request.features.data,
                        request.masks.data)
        response = wire.GetTeamActionsResponse()
        try:
            own = _AgentContext(context)
            actions: TeamActions = self._errors.run(
                "GetTeamRows", "TeamActions", lambda: f"cycle {request.cycle}", own,
                lambda: self._playmaker.GetTeamRows(rows), self._playmaker.GetTeamRows)
        except Failure as failure:
            response.agents.extend(_failed(agent, failure) for agent in players)
        else:
            for agent, reply in actions.replies.items():
                response.agents.add(agent=agent, message=reply.SerializeToString())
            if actions.rows:
                response.actions.shape.extend((len(players), actions.width))
                response.actions.data = actions.rows
        for one in request.agents:
            if one.agent in _OTHER_DECISIONS:
                response.agents.append(self._reply(one.agent, _OTHER_DECISIONS[one.agent],
                                                   proto.State.FromString(one.message), context))
        return response

    def GetTeamActions(self, request: wire.GetTeamActionsRequest,
                       context: Any) -> wire.GetTeamActionsResponse:
        if request.HasField("features"):
            return self._decide_rows(request, context)
        states = {one.agent: proto.State.FromString(one.message) for one in request.agents}
        players = {agent: state for agent, state in states.items() if agent not in _OTHER_DECISIONS}
        failure: Optional[Failure] = None
        decided: Dict[int, proto.PlayerActions] = {}
        try:
            decided = self._decide_together(players, context)
        except Failure as error:
            failure = error
        response = wire.GetTeamActionsResponse()
        for agent, state in states.items():
            if agent in players and failure is not None:
                reply = _failed(agent, failure)
            elif agent in players and agent in decided:
                reply = self._reply(agent, "GetPlayerActions", state, context,
                                    lambda *_, reply=decided[agent]: reply)
            else:
                reply = self._reply(agent, _OTHER_DECISIONS.get(agent, "GetPlayerActions"), state,
                                    context)
            response.agents.append(reply)
        return response

    def GetBestPlannerActions(self, request: wire.GetBestPlannerActionsRequest,
                              context: Any) -> wire.GetBestPlannerActionsResponse:
        return wire.GetBestPlannerActionsResponse(agents=[
            self._reply(one.agent, "GetBestPlannerAction",
                        proto.BestPlannerActionRequest.FromString(one.message), context)
            for one in request.agents])

    def UnregisterTeam(self, request: wire.UnregisterTeamRequest,
                       context: Any) -> wire.UnregisterTeamResponse:
        for one in request.agents:
            self._reply(one.agent, "SendByeCommand",
                        proto.RegisterResponse.FromString(one.message), context)
        return wire.UnregisterTeamResponse()

    def _introduce(self, agent: int, identity: proto.RegisterResponse,
                   request: wire.RegisterTeamRequest, context: Any) -> None:
        """The rest of an agent's handshake. As in protos.Game, it may fail: that is logged."""
        for rpc, kind, messages in (
                ("SendServerParams", proto.ServerParam, [request.server_params]),
                ("SendPlayerParams", proto.PlayerParam, [request.player_params]),
                ("SendPlayerType", proto.PlayerType, request.player_types),
                ("SendInitMessage", proto.InitMessage, [request.init_message])):
            for message in messages:
                parameters = kind.FromString(message)
                parameters.register_response.CopyFrom(identity)
                self._reply(agent, rpc, parameters, context)

    def _decide_together(self, states: Dict[int, proto.State],
                         context: Any) -> Dict[int, proto.PlayerActions]:
        method = getattr(self._playmaker, "GetTeamActions", None)
        if method is None or not states:
            return {}
        any_state = next(iter(states.values()))
        own = _AgentContext(context)
        return self._errors.run(
            "GetTeamActions", "dict",
            lambda: f"{any_state.register_response.team_name} at cycle "
                    f"{any_state.world_model.cycle}",
            own, lambda: method(states, own), method)

    def _reply(self, agent: int, rpc: str, request: Any, context: Any,
               method: Any = None) -> wire.AgentReply:
        try:
            reply = self._errors.call(rpc, method or getattr(self._playmaker, rpc), request,
                                      _AgentContext(context))
        except Failure as failure:
            return _failed(agent, failure)
        return wire.AgentReply(agent=agent, message=reply.SerializeToString())


def _failed(agent: int, failure: Failure) -> wire.AgentReply:
    code = failure.code if isinstance(failure.code, grpc.StatusCode) else grpc.StatusCode.UNKNOWN
    return wire.AgentReply(agent=agent, code=code.value[0], error=failure.text)


class _AgentContext:
    """The context of one agent's call: the team's, with a status of its own."""

    def __init__(self, team: Any) -> None:
        self._team = team
        self._code: Optional[grpc.StatusCode] = None
        self._details = ""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._team, name)

    def code(self) -> Optional[grpc.StatusCode]:
        return self._code

    def details(self) -> str:
        return self._details

    def set_code(self, code: grpc.StatusCode) -> None:
        self._code = code

    def set_details(self, details: str) -> None:
        self._details = details

    def abort(self, code: grpc.StatusCode, details: str) -> None:
        self._code, self._details = code, details
        raise Exception()  # as grpc does

    def abort_with_status(self, status: grpc.Status) -> None:
        self.abort(status.code, status.details)
