// The example team in Go: serves decide.go. Start it with ./run --port N.
package main

import (
	"flag"
	"fmt"
	"log"
	"net"
	"os"
	"os/signal"
	"syscall"
	"time"

	"google.golang.org/grpc"
	pb "team/pb"
	teampb "team/teampb"
)

const grace = time.Second // for calls in flight after SIGTERM or Ctrl-C

func main() {
	port := flag.Int("port", 50051, "listening port; 0 selects a free one")
	coach := flag.Bool("coach", false, "decide for the coach, too")
	flag.Parse()
	log.SetFlags(log.LstdFlags)
	listener, err := net.Listen("tcp", fmt.Sprintf("127.0.0.1:%d", *port))
	if err != nil {
		log.Fatal(err)
	}
	server := grpc.NewServer()
	pb.RegisterGameServer(server, &playmaker{coach: *coach})
	teampb.RegisterTeamPlaymakerServer(server, &teamPlaymaker{game: &playmaker{coach: *coach}})
	stop := make(chan os.Signal, 1)
	signal.Notify(stop, syscall.SIGTERM, os.Interrupt)
	go func() {
		<-stop
		time.AfterFunc(grace, server.Stop)
		server.GracefulStop()
	}()
	fmt.Println("listening on", listener.Addr())
	if err := server.Serve(listener); err != nil {
		log.Fatal(err)
	}
}
