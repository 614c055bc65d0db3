"""A Playmaker on cls_playmaker that is asked for its whole team in one call."""
import unittest

import grpc
from cls_playmaker import Playmaker, complete_state, proto, start
from cls_playmaker import team_playmaker_pb2 as wire
from cls_playmaker.team_playmaker_pb2_grpc import TeamPlaymakerStub

COACH, TRAINER = 12, 13


class Team(Playmaker):
    """Dashes with the player's number as power; some players make mistakes."""

    def __init__(self):
        self.calls = []

    def SendServerParams(self, request, context):
        self.calls.append(("SendServerParams", request.register_response.uniform_number))
        if request.register_response.uniform_number == 3:
            raise ValueError("cannot read")
        return proto.Empty()

    def SendPlayerType(self, request, context):
        self.calls.append(("SendPlayerType", request.register_response.uniform_number, request.id))
        return proto.Empty()

    def SendByeCommand(self, request, context):
        self.calls.append(("SendByeCommand", request.uniform_number))
        return proto.Empty()

    def Register(self, request, context):
        if request.uniform_number == 4:
            context.abort(grpc.StatusCode.PERMISSION_DENIED, "no fourth player")
        return super().Register(request, context)

    def GetPlayerActions(self, request, context):
        unum = request.register_response.uniform_number
        self.calls.append(("GetPlayerActions", unum))
        if request.world_model.cycle == 66 and unum == 9:
            raise ValueError("no plan")
        if request.world_model.cycle == 66 and unum == 10:
            return None
        return dash(unum)

    def GetCoachActions(self, request, context):
        return proto.CoachActions(actions=[proto.CoachAction(
            change_player_types=proto.ChangePlayerType(uniform_number=2, type=5))])

    def GetBestPlannerAction(self, request, context):
        return proto.BestPlannerActionResponse(index=7)


class TeamOfOneMethod(Playmaker):
    """Decides for all players but the goalie in one call."""

    def GetTeamActions(self, states, context):
        cycle = next(iter(states.values())).world_model.cycle
        if cycle == 66:
            raise ValueError("no plan")
        if cycle == 67:
            return [dash(1)]
        return {unum: "left" if cycle == 68 and unum == 5 else dash(10 * len(states))
                for unum in states if unum != 1}


class LeanTeam(Team):
    lean_states = True


class PlainService(proto.GameServicer):
    """A service without the base class."""

    def GetPlayerActions(self, request, context):
        return dash(40)


def dash(power):
    return proto.PlayerActions(actions=[proto.PlayerAction(dash=proto.Dash(power=power))])


def identity(agent):
    role = {COACH: proto.CoachT, TRAINER: proto.TrainerT}.get(agent, proto.PlayerT)
    return {"team_name": "RED", "uniform_number": agent, "agent_type": role}


def states_of(agents, cycle=120):
    return wire.GetTeamActionsRequest(cycle=cycle, agents=[
        wire.AgentMessage(agent=agent, message=proto.State(
            register_response=proto.RegisterResponse(**identity(agent)),
            world_model=proto.WorldModel(cycle=cycle)).SerializeToString())
        for agent in agents])


def power_of(reply):
    return proto.PlayerActions.FromString(reply.message).actions[0].dash.power


class Served(unittest.TestCase):
    def serve(self, playmaker):
        server, port = start(playmaker)
        self.addCleanup(lambda: server.stop(0).wait())
        self.channel = grpc.insecure_channel(f"127.0.0.1:{port}")
        self.addCleanup(self.channel.close)
        self.stub = TeamPlaymakerStub(self.channel)

    def decide(self, agents, cycle=120):
        response = self.stub.GetTeamActions(states_of(agents, cycle), timeout=10)
        self.assertEqual([reply.agent for reply in response.agents], list(agents))
        return {reply.agent: reply for reply in response.agents}

    def register(self, agents, encodings=()):
        return self.stub.RegisterTeam(wire.RegisterTeamRequest(
            version=1, encodings=encodings,
            agents=[wire.AgentMessage(agent=agent, message=proto.RegisterRequest(
                **identity(agent)).SerializeToString()) for agent in agents],
            server_params=proto.ServerParam().SerializeToString(),
            player_types=[proto.PlayerType(id=id).SerializeToString() for id in (0, 1)],
            init_message=proto.InitMessage().SerializeToString()), timeout=10)


class AgentByAgent(Served):
    def test_registers_all_agents_with_their_parameters(self):
        team = Team()
        self.serve(team)
        response = self.register([1, 2, COACH])
        self.assertEqual(response.version, 1)
        registered = [proto.RegisterResponse.FromString(reply.message)
                      for reply in response.agents]
        self.assertEqual([(one.uniform_number, one.agent_type) for one in registered],
                         [(1, proto.PlayerT), (2, proto.PlayerT), (COACH, proto.CoachT)])
        self.assertEqual(team.calls, [
            call for agent in (1, 2, COACH) for call in
            (("SendServerParams", agent), ("SendPlayerType", agent, 0),
             ("SendPlayerType", agent, 1))])

    def test_refuses_one_registration_and_logs_a_failed_parameter(self):
        self.serve(Team())
        with self.assertLogs("cls_playmaker") as logs:
            response = self.register([3, 4, 5])
        self.assertEqual([(reply.code, reply.error) for reply in response.agents],
                         [(0, ""), (7, "no fourth player"), (0, "")])
        self.assertEqual(len(logs.output), 1)
        self.assertIn("player 3 of RED: SendServerParams: ValueError: cannot read", logs.output[0])

    def test_decides_for_players_and_coach_in_turn(self):
        team = Team()
        self.serve(team)
        replies = self.decide(range(1, 13))
        self.assertEqual([power_of(replies[unum]) for unum in range(1, 12)], list(range(1, 12)))
        coach = proto.CoachActions.FromString(replies[COACH].message)
        self.assertEqual(coach.actions[0].change_player_types.type, 5)
        self.assertEqual(team.calls, [("GetPlayerActions", unum) for unum in range(1, 12)])

    def test_reports_an_error_in_the_reply_to_its_agent(self):
        self.serve(Team())
        with self.assertLogs("cls_playmaker") as logs:
            replies = self.decide((8, 9, 10, 11), 66)
        self.assertEqual([replies[unum].code for unum in (8, 9, 10, 11)], [0, 2, 2, 0])
        self.assertEqual((power_of(replies[8]), power_of(replies[11])), (8, 11))
        self.assertRegex(replies[9].error, r"^ValueError: no plan \(team_test.py:\d+\)$")
        self.assertEqual(replies[10].error.split(" (")[0],
                         "TypeError: GetPlayerActions returned NoneType, "
                         "must return proto.PlayerActions")
        self.assertIn("player 9 of RED at cycle 66: GetPlayerActions: ValueError", logs.output[0])
        self.assertIn('raise ValueError("no plan")', logs.output[0])

    def test_says_the_same_in_a_call_of_one_agent(self):
        self.serve(Team())
        request = proto.State.FromString(states_of([9], 66).agents[0].message)
        with self.assertLogs("cls_playmaker") as logs:
            error = self.decide([9], 66)[9].error
            with self.assertRaises(grpc.RpcError) as raised:
                proto.GameStub(self.channel).GetPlayerActions(request, timeout=10)
        self.assertEqual(raised.exception.details(), error)
        self.assertEqual(logs.output[1], logs.output[0].split("\n")[0])

    def test_leaves_the_trainer_unimplemented_without_a_log_line(self):
        self.serve(Team())
        with self.assertNoLogs() if hasattr(self, "assertNoLogs") else self.subTest():
            replies = self.decide([11, TRAINER])
        self.assertEqual((replies[11].code, replies[TRAINER].code),
                         (0, grpc.StatusCode.UNIMPLEMENTED.value[0]))

    def test_chooses_planner_actions_and_says_goodbye(self):
        team = Team()
        self.serve(team)
        chosen = self.stub.GetBestPlannerActions(wire.GetBestPlannerActionsRequest(
            agents=[wire.AgentMessage(agent=agent) for agent in (7, 9)]), timeout=10)
        self.assertEqual([(reply.agent, proto.BestPlannerActionResponse.FromString(
            reply.message).index) for reply in chosen.agents], [(7, 7), (9, 7)])
        self.stub.UnregisterTeam(wire.UnregisterTeamRequest(agents=[
            wire.AgentMessage(agent=agent, message=proto.RegisterResponse(
                **identity(agent)).SerializeToString()) for agent in (7, 9)]), timeout=10)
        self.assertEqual(team.calls, [("SendByeCommand", 7), ("SendByeCommand", 9)])

    def test_serves_a_plain_service(self):
        self.serve(PlainService())
        replies = self.decide([5, COACH])
        self.assertEqual((power_of(replies[5]), replies[COACH].code), (40, 12))
        self.assertEqual([reply.code for reply in self.register([5]).agents], [12])


class Encodings(Served):
    def test_chooses_lean_states_if_both_sides_know_them(self):
        offered = (wire.STATES, wire.LEAN_STATES)
        for team, encodings, chosen in ((LeanTeam(), offered, wire.LEAN_STATES),
                                        (LeanTeam(), (), wire.STATES),
                                        (Team(), offered, wire.STATES),
                                        (PlainService(), offered, wire.STATES)):
            self.serve(team)
            self.assertEqual(self.register([1], encodings).encoding, chosen)

    def test_completes_a_lean_state(self):
        state = proto.State()
        world = state.world_model
        world.teammates.add(uniform_number=4).position.x = 40
        world.opponents.add(uniform_number=5, pos_count=2)
        world.our_players_dict[9].position.x = 90  # the player itself
        world.their_players_dict[-1].pos_count = 7
        self.assertIs(complete_state(state), state)
        self.assertEqual({key: one.position.x for key, one in world.our_players_dict.items()},
                         {4: 40, 9: 90})
        self.assertEqual({key: one.pos_count for key, one in world.their_players_dict.items()},
                         {-1: 7, 5: 2})
        world.teammates[0].position.x = 41  # an entry that is there stays
        self.assertEqual(complete_state(state).world_model.our_players_dict[4].position.x, 40)


class AllPlayersAtOnce(Served):
    def setUp(self):
        self.serve(TeamOfOneMethod())

    def test_decides_for_the_team(self):
        replies = self.decide((1, 2, 3, COACH))
        self.assertEqual([replies[agent].code for agent in (1, 2, 3, COACH)], [12, 0, 0, 12])
        self.assertEqual((power_of(replies[2]), power_of(replies[3])), (30, 30))

    def test_decides_for_a_player_who_asks_alone(self):
        request = proto.State.FromString(states_of([2]).agents[0].message)
        actions = proto.GameStub(self.channel).GetPlayerActions(request, timeout=10)
        self.assertEqual(actions.actions[0].dash.power, 10)

    def test_fails_for_all_players_once(self):
        for cycle, error in ((66, "ValueError: no plan"),
                             (67, "TypeError: GetTeamActions returned list, must return dict")):
            with self.assertLogs("cls_playmaker") as logs:
                replies = self.decide((2, 3, COACH), cycle)
            self.assertEqual([replies[agent].code for agent in (2, 3, COACH)], [2, 2, 12])
            self.assertEqual(replies[2].error.split(" (")[0], error)
            self.assertEqual(len(logs.output), 1)
            self.assertIn(f"RED at cycle {cycle}: GetTeamActions: {error}", logs.output[0])

    def test_names_the_player_with_a_wrong_value(self):
        with self.assertLogs("cls_playmaker") as logs:
            replies = self.decide((4, 5), 68)
        self.assertEqual((replies[4].code, replies[5].code), (0, 2))
        self.assertIn("player 5 of RED at cycle 68: GetPlayerActions: TypeError: "
                      "GetPlayerActions returned str", logs.output[0])


if __name__ == "__main__":
    unittest.main()
