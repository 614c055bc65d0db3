// Implements cls.playmaker.v1.TeamPlaymaker: one call per team and cycle.
using Cls.Playmaker.V1;
using Google.Protobuf;
using Google.Protobuf.Collections;
using Grpc.Core;
using Protos;

namespace Team;

/// <summary>Asks the Playmaker for one agent after the other.</summary>
public sealed class TeamService(Playmaker playmaker) : TeamPlaymaker.TeamPlaymakerBase
{
    private const int Coach = 12;
    private const int Trainer = 13;

    public override Task<RegisterTeamResponse> RegisterTeam(
        RegisterTeamRequest request, ServerCallContext context) =>
        Task.FromResult(new RegisterTeamResponse
        {
            Version = 1,
            Agents = { Replies(request.Agents, RegisterRequest.Parser, playmaker.Register) },
        });

    public override Task<GetTeamActionsResponse> GetTeamActions(
        GetTeamActionsRequest request, ServerCallContext context) =>
        Task.FromResult(TeamActions(request));

    public override Task<GetBestPlannerActionsResponse> GetBestPlannerActions(
        GetBestPlannerActionsRequest request, ServerCallContext context) =>
        Task.FromResult(new GetBestPlannerActionsResponse
        {
            Agents =
            {
                Replies(request.Agents, BestPlannerActionRequest.Parser, playmaker.BestPlannerAction),
            },
        });

    public override Task<UnregisterTeamResponse> UnregisterTeam(
        UnregisterTeamRequest request, ServerCallContext context) =>
        Task.FromResult(new UnregisterTeamResponse());

    public GetTeamActionsResponse TeamActions(GetTeamActionsRequest request) => new()
    {
        Agents = { request.Agents.Select(agent => Reply(agent, State.Parser, DecisionOf(agent.Agent))) },
    };

    private Func<State, IMessage> DecisionOf(int agent) => agent switch
    {
        Coach => playmaker.CoachActions,
        Trainer => playmaker.TrainerActions,
        _ => playmaker.PlayerActions,
    };

    private static IEnumerable<AgentReply> Replies<T>(
        RepeatedField<AgentMessage> agents, MessageParser<T> parser, Func<T, IMessage> method)
        where T : IMessage<T> =>
        agents.Select(agent => Reply(agent, parser, method));

    /// <summary>One agent's reply. What fails for one agent concerns the reply to that agent alone.</summary>
    private static AgentReply Reply<T>(
        AgentMessage agent, MessageParser<T> parser, Func<T, IMessage> method)
        where T : IMessage<T>
    {
        try
        {
            var message = method(parser.ParseFrom(agent.Message));
            return new() { Agent = agent.Agent, Message = message.ToByteString() };
        }
        catch (Exception error)
        {
            var status = Failures.StatusOf(error);
            return new() { Agent = agent.Agent, Code = (int)status.StatusCode, Error = status.Detail };
        }
    }
}
