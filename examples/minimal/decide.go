package main

import pb "team/pb"

// The team's decisions: the place for your own ideas.

// decide returns the actions of one player for one cycle; the first possible body action is executed.
func decide(state *pb.State) *pb.PlayerActions {
	world := state.GetWorldModel()
	switch {
	case world.GetGameModeType() != pb.GameModeType_PlayOn:
		return reply(setPlay())
	case world.GetSelf().GetIsGoalie():
		return reply(goalie())
	case world.GetSelf().GetIsKickable():
		ball := point(world.GetBall().GetPosition())
		return reply(showLine(ball, goal, "yellow"), showText("has the ball"),
			smartKick(goal, 3, 0.1, 3), watchBall(0))
	}
	return reply(basicMove())
}

func reply(actions ...*pb.PlayerAction) *pb.PlayerActions {
	return &pb.PlayerActions{Actions: actions}
}

func decideAsCoach(*pb.State) *pb.CoachActions {
	return &pb.CoachActions{Actions: []*pb.CoachAction{substitute()}}
}

func decideAsTrainer(*pb.State) *pb.TrainerActions { return &pb.TrainerActions{} }
