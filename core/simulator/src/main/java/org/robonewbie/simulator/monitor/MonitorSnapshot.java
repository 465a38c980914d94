package org.robonewbie.simulator.monitor;

import java.util.List;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * What monitors receive about one cycle.
 *
 * @param game the state of the match
 * @param fouls fouls of the match in order; monitors receive those that are new to them, so old ones may be omitted
 * @param ballPlace 16 numbers as in a scene's transform; not to be changed
 * @param things what else stands on the pitch
 * @param robots all robots in the order in which they connected
 */
@SuppressWarnings("ArrayRecordComponent")
public record MonitorSnapshot(
        MonitoredGame game, List<Foul> fouls, float[] ballPlace, List<Thing> things, List<MonitoredRobotState> robots) {

    /**
     * Copies what monitors need from the world.
     *
     * @param game the state of the match
     * @param fouls fouls of the match in order
     * @param world ball and things
     * @param robots all robots in the order in which they connected
     * @return the present state
     */
    public static MonitorSnapshot of(
            MonitoredGame game, List<Foul> fouls, SoccerWorld world, List<MonitoredRobotState> robots) {
        float[] place = new float[16];
        MonitoredRobotState.writePlace(
                new BodyPose(world.ball().position(), world.ball().rotation()), place, 0);
        return new MonitorSnapshot(
                game, List.copyOf(fouls), place, world.things().now(), List.copyOf(robots));
    }
}
