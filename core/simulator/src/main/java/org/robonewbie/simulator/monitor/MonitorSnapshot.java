package org.robonewbie.simulator.monitor;

import java.util.List;
import org.robonewbie.protocol.monitor.Foul;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.SoccerWorld;

/**
 * The state after a cycle, as sent to monitors.
 *
 * @param game the state of the match
 * @param fouls fouls of the match in chronological order; old ones may be omitted, because monitors receive only new
 *     ones
 * @param ballTransform transform of the ball, a 4 × 4 matrix in column-major order; must not be modified
 * @param things other objects on the pitch
 * @param robots all robots in the order in which they connected
 */
@SuppressWarnings("ArrayRecordComponent")
public record MonitorSnapshot(
        MonitoredGame game,
        List<Foul> fouls,
        float[] ballTransform,
        List<Thing> things,
        List<MonitoredRobotState> robots) {

    /**
     * Takes a snapshot of the world for monitors.
     *
     * @param game the state of the match
     * @param fouls fouls of the match in chronological order
     * @param world the world with the ball and other objects
     * @param robots all robots in the order in which they connected
     * @return the current state
     */
    public static MonitorSnapshot of(
            MonitoredGame game, List<Foul> fouls, SoccerWorld world, List<MonitoredRobotState> robots) {
        BodyPose ball = new BodyPose(world.ball().position(), world.ball().rotation());
        return new MonitorSnapshot(
                game,
                List.copyOf(fouls),
                MonitoredRobotState.transform(ball),
                world.things().now(),
                List.copyOf(robots));
    }
}
