package main

import (
	"log"
	"os"
	"sort"
	"strconv"
	"strings"

	pb "team/pb"
)

// The team's decisions: a policy chooses what to do with the ball, the proxy does the rest.

type row struct {
	action  string
	weights []float64
}

// policy has the weights of each action.
var policy = readPolicy()

func readPolicy() (rows []row) {
	path := os.Getenv("POLICY")
	if path == "" {
		path = "policy.txt"
	}
	text, err := os.ReadFile(path)
	if err != nil {
		log.Fatal(err)
	}
	for _, line := range strings.Split(string(text), "\n") {
		words := strings.Fields(line)
		if len(words) == 0 || strings.HasPrefix(line, "#") {
			continue
		}
		one := row{action: words[0]}
		for _, word := range words[1:] {
			weight, err := strconv.ParseFloat(word, 64)
			if err != nil {
				log.Fatal(path, ": ", err)
			}
			one.weights = append(one.weights, weight)
		}
		rows = append(rows, one)
	}
	return
}

// features are what the policy sees, each about 0 to 1: bias, goal, room, lane, own_half.
func features(now *Situation) []float64 {
	ahead := Point{now.me.X + 8, now.me.Y}
	ownHalf := 0.0
	if now.ball.X < 0 {
		ownHalf = 1
	}
	return []float64{1, max(0, 1-distance(now.ball, goal)/50), min(now.room(now.ball), 10) / 10,
		min(max(now.lane(now.me, ahead), 0), 4) / 4, ownHalf}
}

func action(name string) *pb.PlayerAction {
	switch name {
	case "shoot":
		return smartKick(goal, 3, 2, 2)
	case "pass":
		return &pb.PlayerAction{Action: &pb.PlayerAction_HeliosOffensivePlanner{
			HeliosOffensivePlanner: &pb.HeliosOffensivePlanner{
				DirectPass: true, LeadPass: true, ThroughPass: true, MaxDepth: 1}}}
	case "dribble":
		return dribble(goal, 90, 4)
	case "clear":
		return clearBall()
	}
	return holdBall(goal)
}

// withBall returns all actions, the one with the highest score first: the first possible one is
// executed.
func withBall(now *Situation) []*pb.PlayerAction {
	seen := features(now)
	scores := make([]float64, len(policy))
	order := make([]int, len(policy))
	for i, one := range policy {
		order[i] = i
		for j, weight := range one.weights {
			scores[i] += product(weight, seen[j])
		}
	}
	sort.SliceStable(order, func(a, b int) bool { return scores[order[a]] > scores[order[b]] })
	var chosen []*pb.PlayerAction
	for _, i := range order {
		chosen = append(chosen, action(policy[i].action))
	}
	return append(chosen, watchBall(0))
}

// decide returns the actions of one player for one cycle.
func decide(state *pb.State) *pb.PlayerActions {
	now := newSituation(state)
	switch {
	case now.world.GetIsPenaltyKickMode():
		return reply(penalty())
	case now.world.GetGameModeType() != pb.GameModeType_PlayOn:
		return reply(setPlay())
	case now.self.GetIsGoalie():
		return reply(goalie())
	case now.self.GetIsKickable():
		return reply(withBall(now)...)
	}
	return reply(basicMove(), watchBall(1))
}

func reply(actions ...*pb.PlayerAction) *pb.PlayerActions {
	return &pb.PlayerActions{Actions: actions}
}

func decideAsCoach(*pb.State) *pb.CoachActions {
	return &pb.CoachActions{Actions: []*pb.CoachAction{substitute(), sayPlayerTypes()}}
}

func decideAsTrainer(*pb.State) *pb.TrainerActions { return &pb.TrainerActions{} }
