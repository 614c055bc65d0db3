// Implements protos.Game: one call per agent and cycle.
using Grpc.Core;
using Protos;

namespace Team;

public sealed class GameService(Playmaker playmaker) : Game.GameBase
{
    private static readonly Task<Empty> Done = Task.FromResult(new Empty());

    public override Task<RegisterResponse> Register(RegisterRequest request, ServerCallContext context) =>
        Task.FromResult(playmaker.Register(request));

    public override Task<Empty> SendServerParams(ServerParam request, ServerCallContext context) => Done;

    public override Task<Empty> SendPlayerParams(PlayerParam request, ServerCallContext context) => Done;

    public override Task<Empty> SendPlayerType(PlayerType request, ServerCallContext context) => Done;

    public override Task<Empty> SendInitMessage(InitMessage request, ServerCallContext context) => Done;

    public override Task<Empty> SendByeCommand(RegisterResponse request, ServerCallContext context) => Done;

    public override Task<PlayerActions> GetPlayerActions(State state, ServerCallContext context) =>
        Task.FromResult(playmaker.PlayerActions(state));

    public override Task<CoachActions> GetCoachActions(State state, ServerCallContext context) =>
        Task.FromResult(playmaker.CoachActions(state));

    public override Task<TrainerActions> GetTrainerActions(State state, ServerCallContext context) =>
        Task.FromResult(playmaker.TrainerActions(state));

    public override Task<BestPlannerActionResponse> GetBestPlannerAction(
        BestPlannerActionRequest request, ServerCallContext context) =>
        Task.FromResult(playmaker.BestPlannerAction(request));
}
