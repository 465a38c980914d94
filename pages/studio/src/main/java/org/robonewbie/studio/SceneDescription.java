package org.robonewbie.studio;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Thing;

/**
 * The part of the world that rarely changes: pitch, teams and robots. Sent to each page once, and again after each change.
 *
 * @param field the pitch
 * @param clock whether the clock can be paused
 * @param agentPort the TCP port of the agent server; empty if there is none
 * @param puppets whether manually controlled robots (puppets) can join
 * @param trial the running trial; empty for free play
 * @param teamLeft name of the left team, empty before it joins
 * @param teamRight name of the right team, empty before it joins
 * @param robots the robots in the order of the state frames
 * @param things other objects on the pitch, in the order of the state frames
 */
record SceneDescription(
        SoccerField field,
        boolean clock,
        OptionalInt agentPort,
        boolean puppets,
        Optional<TrialLabel> trial,
        String teamLeft,
        String teamRight,
        List<Player> robots,
        List<Standing> things) {

    /**
     * Static properties of a robot.
     *
     * @param id number of its connection
     * @param team name of its team, empty before it joins one
     * @param side side of its team, empty before it joins one
     * @param number its player number, 0 before it joins a team
     * @param type its body type
     * @param puppet whether the user controls it manually
     */
    record Player(int id, String team, Optional<TeamSide> side, int number, RobotType type, boolean puppet) {

        static Player of(RobotSnapshot robot, boolean puppet) {
            return new Player(robot.id(), robot.team(), robot.side(), robot.number(), robot.type(), puppet);
        }
    }

    /**
     * Static properties of an object on the pitch.
     *
     * @param name kind of the object
     * @param size edge lengths in metres
     * @param movable whether it can be pushed
     */
    record Standing(String name, Vector3 size, boolean movable) {

        static Standing of(Thing thing) {
            return new Standing(thing.name(), thing.size(), thing.isMovable());
        }
    }

    static SceneDescription of(SimulationControl simulation, PuppetService service, WorldSnapshot snapshot) {
        return new SceneDescription(
                simulation.field(),
                simulation.hasClock(),
                simulation.agentPort(),
                service.isOpen(),
                simulation.trial(),
                snapshot.teamLeft(),
                snapshot.teamRight(),
                snapshot.robots().stream()
                        .map(robot -> Player.of(robot, service.isPuppet(robot)))
                        .toList(),
                snapshot.things().stream().map(Standing::of).toList());
    }
}
