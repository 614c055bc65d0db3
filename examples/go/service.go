package main

import (
	"context"
	"fmt"
	"log"
	"path/filepath"
	"runtime"
	"runtime/debug"
	"strings"

	"google.golang.org/grpc/codes"
	"google.golang.org/grpc/status"
	"google.golang.org/protobuf/proto"
	pb "team/pb"
	teampb "team/teampb"
)

// playmaker implements protos.Game: one call per agent and cycle.
type playmaker struct {
	pb.UnimplementedGameServer
	coach bool
}

func (*playmaker) Register(_ context.Context, request *pb.RegisterRequest) (*pb.RegisterResponse, error) {
	return &pb.RegisterResponse{ClientId: request.UniformNumber, AgentType: request.AgentType,
		TeamName: request.TeamName, UniformNumber: request.UniformNumber,
		RpcServerLanguageType: pb.RpcServerLanguageType_GO}, nil
}

func (*playmaker) SendServerParams(context.Context, *pb.ServerParam) (*pb.Empty, error) {
	return &pb.Empty{}, nil
}

func (*playmaker) SendPlayerParams(context.Context, *pb.PlayerParam) (*pb.Empty, error) {
	return &pb.Empty{}, nil
}

func (*playmaker) SendPlayerType(context.Context, *pb.PlayerType) (*pb.Empty, error) {
	return &pb.Empty{}, nil
}

func (*playmaker) SendInitMessage(context.Context, *pb.InitMessage) (*pb.Empty, error) {
	return &pb.Empty{}, nil
}

func (*playmaker) SendByeCommand(context.Context, *pb.RegisterResponse) (*pb.Empty, error) {
	return &pb.Empty{}, nil
}

func (*playmaker) GetPlayerActions(_ context.Context, state *pb.State) (actions *pb.PlayerActions, err error) {
	defer reportPanic(state, &err)
	return decide(state), nil
}

func (game *playmaker) GetCoachActions(_ context.Context, state *pb.State) (actions *pb.CoachActions, err error) {
	if !game.coach {
		return nil, status.Error(codes.Unimplemented, "started without --coach")
	}
	defer reportPanic(state, &err)
	return decideAsCoach(state), nil
}

func (*playmaker) GetTrainerActions(_ context.Context, state *pb.State) (actions *pb.TrainerActions, err error) {
	defer reportPanic(state, &err)
	return decideAsTrainer(state), nil
}

// GetBestPlannerAction selects the node with the highest value; the lowest index among equal ones.
func (*playmaker) GetBestPlannerAction(_ context.Context, request *pb.BestPlannerActionRequest) (*pb.BestPlannerActionResponse, error) {
	best := int32(-1)
	for index, node := range request.Pairs {
		value := node.GetEvaluation()
		if best == -1 || value > request.Pairs[best].GetEvaluation() ||
			(value == request.Pairs[best].GetEvaluation() && index < best) {
			best = index
		}
	}
	return &pb.BestPlannerActionResponse{Index: best}, nil
}

// reportPanic turns a panic of a decision into the status of its call, so that one player's mistake
// costs one decision.
func reportPanic(state *pb.State, err *error) {
	if problem := recover(); problem != nil {
		log.Printf("player %d at cycle %d: %v\n%s", state.GetRegisterResponse().GetUniformNumber(),
			state.GetWorldModel().GetCycle(), problem, debug.Stack())
		*err = status.Error(codes.Unknown, fmt.Sprint(problem, placeOfPanic()))
	}
}

// placeOfPanic is " (decide.go:83)", the line of this program that panicked.
func placeOfPanic() string {
	callers := make([]uintptr, 64)
	frames := runtime.CallersFrames(callers[:runtime.Callers(0, callers)])
	for panicked := false; ; {
		frame, more := frames.Next()
		if panicked && !strings.HasPrefix(frame.Function, "runtime.") {
			return fmt.Sprintf(" (%s:%d)", filepath.Base(frame.File), frame.Line)
		}
		panicked = panicked || frame.Function == "runtime.gopanic"
		if !more {
			return ""
		}
	}
}

// teamPlaymaker implements cls.playmaker.v1.TeamPlaymaker: one call per team and cycle. It asks the
// Game for one agent after the other.
type teamPlaymaker struct {
	teampb.UnimplementedTeamPlaymakerServer
	game *playmaker
}

const (
	coachNumber   = 12
	trainerNumber = 13
)

func (team *teamPlaymaker) RegisterTeam(ctx context.Context, request *teampb.RegisterTeamRequest) (*teampb.RegisterTeamResponse, error) {
	return &teampb.RegisterTeamResponse{Version: 1, Agents: each(ctx, request.Agents, team.game.Register)}, nil
}

func (team *teamPlaymaker) GetTeamActions(ctx context.Context, request *teampb.GetTeamActionsRequest) (*teampb.GetTeamActionsResponse, error) {
	response := &teampb.GetTeamActionsResponse{}
	for _, agent := range request.Agents {
		one := []*teampb.AgentMessage{agent}
		switch agent.Agent {
		case coachNumber:
			response.Agents = append(response.Agents, each(ctx, one, team.game.GetCoachActions)...)
		case trainerNumber:
			response.Agents = append(response.Agents, each(ctx, one, team.game.GetTrainerActions)...)
		default:
			response.Agents = append(response.Agents, each(ctx, one, team.game.GetPlayerActions)...)
		}
	}
	return response, nil
}

func (team *teamPlaymaker) GetBestPlannerActions(ctx context.Context, request *teampb.GetBestPlannerActionsRequest) (*teampb.GetBestPlannerActionsResponse, error) {
	return &teampb.GetBestPlannerActionsResponse{
		Agents: each(ctx, request.Agents, team.game.GetBestPlannerAction)}, nil
}

func (team *teamPlaymaker) UnregisterTeam(ctx context.Context, request *teampb.UnregisterTeamRequest) (*teampb.UnregisterTeamResponse, error) {
	each(ctx, request.Agents, team.game.SendByeCommand)
	return &teampb.UnregisterTeamResponse{}, nil
}

// each calls a method of the Game with the message of each agent. What fails for one agent concerns
// the reply to that agent alone.
func each[Request any, Reply proto.Message, Pointer interface {
	*Request
	proto.Message
}](ctx context.Context, agents []*teampb.AgentMessage, method func(context.Context, Pointer) (Reply, error)) []*teampb.AgentReply {
	var replies []*teampb.AgentReply
	for _, agent := range agents {
		answer := &teampb.AgentReply{Agent: agent.Agent}
		request := Pointer(new(Request))
		err := proto.Unmarshal(agent.Message, request)
		if err == nil {
			var reply Reply
			if reply, err = method(ctx, request); err == nil {
				answer.Message, err = proto.Marshal(reply)
			}
		}
		if err != nil {
			answer.Code, answer.Error = int32(status.Code(err)), status.Convert(err).Message()
		}
		replies = append(replies, answer)
	}
	return replies
}
