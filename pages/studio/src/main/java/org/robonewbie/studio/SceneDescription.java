package org.robonewbie.studio;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.robot.RobotState;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Thing;

/**
 * The part of the world that rarely changes: pitch, teams and robots. Sent to each page once, and again after each change.
 *
 * @param field the pitch
 * @param details ball and markings of the pitch
 * @param clock whether the clock can be paused
 * @param match whether play mode, score and time can be set
 * @param agentPort the TCP port of the agent server; empty if there is none
 * @param puppets whether manually controlled robots (puppets) can join
 * @param trial the running trial; empty for free play
 * @param teamLeft name of the left team, empty before it joins
 * @param teamRight name of the right team, empty before it joins
 * @param models models of the robots that are not NAOs
 * @param robots the robots in the order of the state frames
 * @param things other objects on the pitch, in the order of the state frames
 */
record SceneDescription(
        SoccerField field,
        PitchDetails details,
        boolean clock,
        boolean match,
        OptionalInt agentPort,
        boolean puppets,
        Optional<TrialLabel> trial,
        String teamLeft,
        String teamRight,
        List<RobotModel> models,
        List<Player> robots,
        List<Standing> things) {

    /**
     * Static properties of a robot.
     *
     * @param id number of its connection
     * @param team name of its team, empty before it joins one
     * @param side side of its team, empty before it joins one
     * @param number its player number, 0 before it joins a team
     * @param type name of its type: {@code TYPE_0} to {@code TYPE_4} for a NAO, otherwise {@code TYPE_5} for the first of {@link
     *     SceneDescription#models}, and so on
     * @param puppet whether the user controls it manually
     */
    record Player(int id, String team, Optional<TeamSide> side, int number, String type, boolean puppet) {

        static Player of(RobotSnapshot robot, List<RobotModel> models, boolean puppet) {
            String type = robot.state() instanceof RobotState.OfNao nao
                    ? nao.body().type().name()
                    : modelType(models.indexOf(robot.state().model()));
            return new Player(robot.id(), robot.team(), robot.side(), robot.number(), type, puppet);
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

    /** Returns the name of the type that a model defines. */
    static String modelType(int index) {
        return "TYPE_" + (RobotType.values().length + index);
    }

    static SceneDescription of(SimulationControl simulation, PuppetService service, WorldSnapshot snapshot) {
        List<RobotModel> models = snapshot.robots().stream()
                .map(RobotSnapshot::state)
                .filter(RobotState.OfModel.class::isInstance)
                .map(RobotState::model)
                .distinct()
                .toList();
        return new SceneDescription(
                simulation.field(),
                simulation.pitchDetails(),
                simulation.hasClock(),
                simulation.canSetMatch(),
                simulation.agentPort(),
                service.isOpen(),
                simulation.trial(),
                snapshot.teamLeft(),
                snapshot.teamRight(),
                models,
                snapshot.robots().stream()
                        .map(robot -> Player.of(robot, models, service.isPuppet(robot)))
                        .toList(),
                snapshot.things().stream().map(Standing::of).toList());
    }
}
