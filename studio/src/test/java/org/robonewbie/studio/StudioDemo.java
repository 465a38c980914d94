package org.robonewbie.studio;

import java.io.IOException;
import java.util.Map;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;

/** Shows the studio by hand: {@code StudioDemo PORT ROBOTS}. */
final class StudioDemo {

    private StudioDemo() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        SmallSimulation simulation = new SmallSimulation();
        int robots = Integer.parseInt(args[1]);
        for (int i = 0; i < robots; i++) {
            TeamSide side = i % 2 == 0 ? TeamSide.LEFT : TeamSide.RIGHT;
            double x = (side == TeamSide.LEFT ? -1 : 1) * (0.8 + 0.8 * ((i / 2) % 4));
            double y = 0.3 + 1.1 * ((i / 8) - 1) * (i / 8 == 0 ? 0 : 1);
            Map<Joint, Double> posture = i == 0 ? Posture.GREETING : Posture.STANDING;
            simulation.withRobot(
                    RobotType.values()[(i / 2) % 5], side, i / 2 + 1, x, y, side == TeamSide.LEFT ? 0 : 180, posture);
        }
        StudioServer studio = StudioServer.start(simulation.start(), Integer.parseInt(args[0]), AccessToken.random());
        System.out.println(studio.address());
        Thread.currentThread().join();
    }
}
