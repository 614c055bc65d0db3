package main

import (
	"context"
	"os"
	"testing"

	"google.golang.org/protobuf/proto"
	pb "team/pb"
	teampb "team/teampb"
)

// The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py.
func TestRepliesToRecordedStates(t *testing.T) {
	request, expected := &teampb.GetTeamActionsRequest{}, &teampb.GetTeamActionsResponse{}
	read(t, "../../fixtures/team/states.bin", request)
	read(t, "../../fixtures/team/replies.bin", expected)
	team := &teamPlaymaker{game: &playmaker{coach: true}}
	actual, err := team.GetTeamActions(context.Background(), request)
	if err != nil {
		t.Fatal(err)
	}
	if len(expected.Agents) < 50 || len(actual.Agents) != len(expected.Agents) {
		t.Fatalf("%d replies, expected %d", len(actual.Agents), len(expected.Agents))
	}
	for i, reply := range expected.Agents {
		if wanted, got := parsed(t, reply), parsed(t, actual.Agents[i]); !proto.Equal(wanted, got) {
			t.Errorf("State %d: %v, expected %v", i, got, wanted)
		}
	}
}

func read(t *testing.T, path string, message proto.Message) {
	t.Helper()
	data, err := os.ReadFile(path)
	if err == nil {
		err = proto.Unmarshal(data, message)
	}
	if err != nil {
		t.Fatal(err)
	}
}

func parsed(t *testing.T, reply *teampb.AgentReply) proto.Message {
	t.Helper()
	var message proto.Message = &pb.PlayerActions{}
	switch reply.Agent {
	case coachNumber:
		message = &pb.CoachActions{}
	case trainerNumber:
		message = &pb.TrainerActions{}
	}
	if err := proto.Unmarshal(reply.Message, message); reply.Code != 0 || err != nil {
		t.Fatal(reply.Error, err)
	}
	return message
}
