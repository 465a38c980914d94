package org.robonewbie.studio;
import java.nio.file.*;
final class RoomProbe {
    public static void main(String[] args) throws Exception {
        try (PlayingRobot robot = PlayingRobot.start();
             StudioServer studio = StudioServer.start(robot.simulator().control(), 0, AccessToken.random());
             Chromium browser = Chromium.open(1366, 768)) {
            browser.visit(studio.address() + "&quality=lowest&theme=" + args[0] + "#" + args[1]);
            for (int i = 2; i < args.length; i++) {
                java.util.concurrent.locks.LockSupport.parkNanos(2_500_000_000L);
                try { System.out.println(args[i] + " -> " + browser.evaluate(args[i])); } catch (Throwable e) { System.out.println(e); }
            }
            System.out.println(browser.complaints());
            Files.write(Path.of("/tmp/room-shot.png"), browser.screenshot());
        }
    }
}
