package main

import (
	"math"

	pb "team/pb"
)

const (
	far    = 1000.0 // meters or cycles: no player is there
	maxAge = 20     // cycles; older estimates of players are ignored
)

// Point is a position on the pitch in meters.
type Point struct{ X, Y float64 }

// goal is the opponent's: every team attacks toward +x.
var goal = Point{52.5, 0}

// Products are converted to float64, so that no processor fuses them with a sum: every language
// computes the same bits.
func product(a, b float64) float64 { return float64(a * b) }

func length(dx, dy float64) float64 { return math.Sqrt(product(dx, dx) + product(dy, dy)) }

func distance(a, b Point) float64 { return length(a.X-b.X, a.Y-b.Y) }

func clamp(value, low, high float64) float64 {
	if value < low {
		return low
	}
	if value > high {
		return high
	}
	return value
}

func point(vector *pb.RpcVector2D) Point {
	return Point{float64(vector.GetX()), float64(vector.GetY())}
}

// Situation is the State of one player, with the facts that most decisions begin with.
type Situation struct {
	world     *pb.WorldModel
	self      *pb.Self
	me, ball  Point
	opponents []Point
	// Cycles to the ball: of this player, its fastest teammate, the fastest opponent.
	mySteps, ourSteps, theirSteps int32
}

func newSituation(state *pb.State) *Situation {
	world := state.GetWorldModel()
	table := world.GetInterceptTable()
	now := &Situation{
		world:   world,
		self:    world.GetSelf(),
		me:      point(world.GetSelf().GetPosition()),
		ball:    point(world.GetBall().GetPosition()),
		mySteps: table.GetSelfReachSteps(),
		ourSteps: steps(world.GetKickableTeammateExistance(),
			table.GetFirstTeammateId(), table.GetFirstTeammateReachSteps()),
		theirSteps: steps(world.GetKickableOpponentExistance(),
			table.GetFirstOpponentId(), table.GetFirstOpponentReachSteps()),
	}
	if now.self.GetIsKickable() {
		now.mySteps = 0
	}
	for _, player := range world.GetOpponents() {
		if player.GetPosCount() <= maxAge {
			now.opponents = append(now.opponents, point(player.GetPosition()))
		}
	}
	return now
}

// steps is the number of cycles to the ball; a player id of 0 means that no such player is known.
func steps(kickable bool, playerID, cycles int32) int32 {
	switch {
	case kickable:
		return 0
	case playerID == 0:
		return far
	}
	return cycles
}

// room is the distance of the nearest opponent.
func (now *Situation) room(place Point) float64 {
	nearest := far
	for _, opponent := range now.opponents {
		nearest = min(nearest, distance(opponent, place))
	}
	return nearest
}

// lane says how far opponents stay away from a ball that rolls from start to end; below 0 they
// reach it. An opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls.
func (now *Situation) lane(start, end Point) float64 {
	dx := end.X - start.X
	dy := end.Y - start.Y
	whole := length(dx, dy)
	if whole < 0.1 {
		return far
	}
	free := far
	for _, opponent := range now.opponents {
		along := (product(opponent.X-start.X, dx) + product(opponent.Y-start.Y, dy)) / whole
		if along < 0 {
			continue
		}
		along = min(along, whole)
		share := along / whole
		passed := Point{start.X + product(dx, share), start.Y + product(dy, share)}
		free = min(free, distance(opponent, passed)-0.8-product(0.2, along))
	}
	return free
}
