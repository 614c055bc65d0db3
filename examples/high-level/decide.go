package main

import pb "team/pb"

// The team's decisions by the behaviors of the proxy: which of them, and with which values.

const shot = 20.0 // meters to the goal

// decide returns the actions of one player for one cycle; the first possible body action is executed.
func decide(state *pb.State) *pb.PlayerActions {
	world := state.GetWorldModel()
	self := world.GetSelf()
	switch {
	case world.GetIsPenaltyKickMode():
		return reply(penalty())
	case world.GetGameModeType() != pb.GameModeType_PlayOn:
		return reply(setPlay())
	case self.GetIsGoalie():
		return reply(goalie())
	case self.GetIsKickable():
		defends := self.GetUniformNumber() >= 2 && self.GetUniformNumber() <= 5
		shots := []*pb.PlayerAction{shoot()}
		if distance(point(world.GetBall().GetPosition()), goal) < shot {
			shots = append(shots, smartKick(goal, 3, 2, 2))
		}
		return reply(append(shots, plan(defends), holdBall(goal), watchBall(0))...)
	}
	return reply(basicMove(), watchBall(1))
}

func reply(actions ...*pb.PlayerAction) *pb.PlayerActions {
	return &pb.PlayerActions{Actions: actions}
}

// plan searches chains of passes and dribbles. Defenders pass rather than dribble.
func plan(defends bool) *pb.PlayerAction {
	return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosOffensivePlanner{
		HeliosOffensivePlanner: &pb.HeliosOffensivePlanner{
			DirectPass: true, LeadPass: true, ThroughPass: true, ShortDribble: true,
			LongDribble: !defends, Cross: !defends, SimplePass: true, SimpleDribble: true,
			SimpleShoot: true, Evaluation: evaluation(defends)}}}
}

// evaluation has factors by the first action of a chain, and costs of opponents at 0, 1, 2, ... meters.
func evaluation(defends bool) *pb.PlannerEvaluation {
	factors := &pb.ActionTypeEffector{DirectPass: 1, LeadPass: 1, ThroughPass: 1.1,
		ShortDribble: 1, LongDribble: 1, Cross: 1, Hold: 1}
	if defends {
		factors.DirectPass, factors.ShortDribble = 1.2, 0.8
	}
	return &pb.PlannerEvaluation{Effectors: &pb.PlannerEvaluationEffector{
		ActionTypeEffector: factors,
		OpponentEffector:   &pb.OpponentEffector{NegetiveEffectByDistance: []float32{-8, -5, -2}}}}
}

func decideAsCoach(*pb.State) *pb.CoachActions {
	return &pb.CoachActions{Actions: []*pb.CoachAction{substitute(), sayPlayerTypes()}}
}

func decideAsTrainer(*pb.State) *pb.TrainerActions { return &pb.TrainerActions{} }
