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
 * What of the world seldom changes: the pitch, the teams and who plays. Pages get it once and again after each change.
 *
 * @param field the pitch
 * @param clock whether time can be stopped
 * @param agentPort the TCP port at which agents join; empty where they cannot
 * @param puppets whether robots can join that people steer
 * @param trial the trial that is judged; empty where everybody just plays
 * @param teamLeft name of the left team, empty before it joined
 * @param teamRight name of the right team, empty before it joined
 * @param robots the robots in the order of the state frames
 * @param things what else stands on the pitch, in the order of the state frames
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
     * One robot without its state.
     *
     * @param id number of its connection
     * @param team name of its team, empty before it joined one
     * @param side its half, empty before it joined a team
     * @param number its number, 0 before it joined a team
     * @param type its build
     * @param puppet whether people steer it
     */
    record Player(int id, String team, Optional<TeamSide> side, int number, RobotType type, boolean puppet) {

        static Player of(RobotSnapshot robot, boolean puppet) {
            return new Player(robot.id(), robot.team(), robot.side(), robot.number(), robot.type(), puppet);
        }
    }

    /**
     * Something that stands on the pitch, without its place.
     *
     * @param name what it is
     * @param size its edges, metres
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
