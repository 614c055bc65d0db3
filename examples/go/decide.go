package main

import pb "team/pb"

// The team's decisions: the place for your own ideas. examples/TEAM.md of cls describes the team.

// home is a position with the ball at the center mark, and how much of the ball's way it follows.
type home struct {
	x, y, followX, followY, minX, maxX float64
	kickOff                            Point
}

// formation is a 4-3-3 by uniform number; 1 is the goalie.
var formation = [11]home{
	{-50, 0, 0, 0, -50, -50, Point{-50, 0}},
	{-20, -7, 0.60, 0.25, -45, 14, Point{-20, -7}},
	{-20, 7, 0.60, 0.25, -45, 14, Point{-20, 7}},
	{-17, -20, 0.65, 0.25, -43, 28, Point{-18, -20}},
	{-17, 20, 0.65, 0.25, -43, 28, Point{-18, 20}},
	{-7, 0, 0.70, 0.45, -38, 32, Point{-11, 0}},
	{1, -12, 0.75, 0.35, -34, 40, Point{-8, -11}},
	{1, 12, 0.75, 0.35, -34, 40, Point{-8, 11}},
	{15, -25, 0.75, 0.15, -24, 47, Point{-1.5, -22}},
	{15, 25, 0.75, 0.15, -24, 47, Point{-1.5, 22}},
	{18, 0, 0.75, 0.30, -16, 47, Point{-0.8, 0}},
}

// 0, 37, -37, 53 and -53 degrees: exact sides of a right triangle.
var dribbleDirections = [5]Point{{1, 0}, {0.8, 0.6}, {0.8, -0.6}, {0.6, 0.8}, {0.6, -0.8}}

type pass struct {
	target       Point
	speed, value float64
}

// decide returns the actions of one player for one cycle; the first possible body action is executed.
func decide(state *pb.State) *pb.PlayerActions {
	now := newSituation(state)
	switch mode := now.world.GetGameModeType(); {
	case now.world.GetIsPenaltyKickMode():
		return reply(penalty())
	case mode == pb.GameModeType_BeforeKickOff || mode == pb.GameModeType_AfterGoal_:
		own := formation[now.self.GetUniformNumber()-1]
		return &pb.PlayerActions{IgnorePreprocess: true,
			Actions: []*pb.PlayerAction{beforeKickOff(own.kickOff), watchBall(0)}}
	case mode != pb.GameModeType_PlayOn:
		return reply(setPlay())
	case now.self.GetIsGoalie():
		return reply(goalie())
	case now.self.GetIsKickable():
		return reply(withBall(now)...)
	}
	return reply(withoutBall(now)...)
}

func reply(actions ...*pb.PlayerAction) *pb.PlayerActions {
	return &pb.PlayerActions{Actions: actions}
}

// decideAsCoach returns substitutions, and the opponents' player types for the players.
func decideAsCoach(*pb.State) *pb.CoachActions {
	return &pb.CoachActions{Actions: []*pb.CoachAction{substitute(), sayPlayerTypes()}}
}

// decideAsTrainer may move ball and players: a place for exercises. This one watches.
func decideAsTrainer(*pb.State) *pb.TrainerActions { return &pb.TrainerActions{} }

func withBall(now *Situation) []*pb.PlayerAction {
	chosen := []*pb.PlayerAction{shoot()}
	corner, canShoot := shot(now)
	if canShoot {
		chosen = append(chosen, smartKick(corner, 3, 2, 2))
	}
	pressed := now.room(now.ball) < 3
	best, canPass := bestPass(now)
	if canPass && (pressed || best.value > value(now, now.ball)+2) {
		chosen = append(chosen, smartKick(best.target, best.speed, product(best.speed, 0.8), 3))
	}
	if pressed && now.ball.X < -20 {
		chosen = append(chosen, clearBall())
	}
	dashes := int32(4)
	if pressed {
		dashes = 2
	}
	chosen = append(chosen, dribble(dribbleTarget(now), 90, dashes), holdBall(goal))
	if canShoot {
		return append(chosen, watchGoalie())
	}
	return append(chosen, watchBall(0))
}

// shot is the place between the posts that opponents are farthest from.
func shot(now *Situation) (best Point, found bool) {
	if distance(now.ball, goal) > 20 {
		return
	}
	widest := 0.0
	for _, y := range []float64{-6, -3, 0, 3, 6} {
		target := Point{goal.X, y}
		if margin := now.lane(now.ball, target); margin > widest {
			best, widest, found = target, margin, true
		}
	}
	return
}

// value of the ball at a place: forward, near the goal, away from opponents.
func value(now *Situation, place Point) float64 {
	return place.X - product(0.2, distance(place, goal)) + product(0.6, min(now.room(place), 8))
}

func bestPass(now *Situation) (best pass, found bool) {
	for _, mate := range now.world.GetTeammates() {
		if mate.GetPosCount() > 8 || mate.GetIsGoalie() || mate.GetIsTackling() {
			continue
		}
		place := point(mate.GetPosition())
		line := float64(now.world.GetOffsideLineX()) - 0.3
		if place.X > 0 && place.X > line && place.X > now.ball.X {
			continue // offside
		}
		ahead := 3.0
		if place.X >= 36 {
			ahead = 0
		}
		run := point(mate.GetVelocity())
		target := Point{clamp(place.X+product(2, run.X)+ahead, -50, 50),
			clamp(place.Y+product(2, run.Y), -32, 32)}
		way := distance(now.ball, target)
		if way < 5 || way > 32 || (target.X < -25 && target.X < now.ball.X) {
			continue // too short, too long, or toward the own goal
		}
		if now.lane(now.ball, target) < 0 {
			continue
		}
		option := pass{target, min(1.2+product(0.06, way), 2.7), value(now, target)}
		if !found || option.value > best.value {
			best, found = option, true
		}
	}
	return
}

// dribbleTarget is 8 m ahead toward the goal, past the opponents in the way.
func dribbleTarget(now *Situation) Point {
	away := distance(now.me, goal)
	if away < 0.1 {
		return goal
	}
	dx := (goal.X - now.me.X) / away
	dy := (goal.Y - now.me.Y) / away
	best, bestRoom := goal, -1000.0
	for index, turn := range dribbleDirections {
		target := Point{now.me.X + product(8, product(dx, turn.X)-product(dy, turn.Y)),
			now.me.Y + product(8, product(dx, turn.Y)+product(dy, turn.X))}
		if target.Y < -32 || target.Y > 32 || target.X > 51 {
			continue
		}
		room := min(now.lane(now.me, target), 4) - product(0.5, float64(index))
		if room > bestRoom {
			best, bestRoom = target, room
		}
	}
	return best
}

func withoutBall(now *Situation) []*pb.PlayerAction {
	first := now.mySteps <= now.ourSteps
	if first && now.mySteps <= now.theirSteps+1 {
		return []*pb.PlayerAction{intercept(goal), turnToBall(), watchBall(0)}
	}
	if now.theirSteps <= now.ourSteps || first {
		return []*pb.PlayerAction{basicMove(), watchBall(1)}
	}
	place := homePosition(now)
	return []*pb.PlayerAction{goTo(place, 0.8, dashPower(now, place)), turnToBall(), watchBall(2)}
}

// homePosition: the formation moves with the ball; forwards wait on the offside line.
func homePosition(now *Situation) Point {
	own := formation[now.self.GetUniformNumber()-1]
	line := float64(now.world.GetOffsideLineX()) - 0.5
	x := clamp(own.x+product(own.followX, now.ball.X), own.minX, own.maxX)
	if now.self.GetUniformNumber() >= 9 {
		x = max(x, min(min(line, now.ball.X+22), 46))
	}
	x = min(x, max(line, 0))
	return Point{x, clamp(own.y+product(own.followY, now.ball.Y), -32, 32)}
}

// dashPower: stamina must last for a half.
func dashPower(now *Situation, target Point) float64 {
	switch {
	case now.self.GetStamina() < 3500:
		return 35
	case now.me.X > target.X+3 || distance(now.ball, target) < 15:
		return 100
	}
	return 65
}
