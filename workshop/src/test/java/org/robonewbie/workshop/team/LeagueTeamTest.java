package org.robonewbie.workshop.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.running.RobotThreads;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.team.Agent_Team;
import org.robonewbie.workshop.RunningLeagueServer;

/** A match of the example team against itself, seven T1 a side, on a real RCSSServerMJ. */
@Tag("slow")
@Timeout(1500)
class LeagueTeamTest {

    private static final int PLAYERS = 7;
    private static final double SECONDS = 60;

    @Test
    void fourteenRobotsPlayForAMinute() throws Exception {
        Referee referee = new Referee();
        List<AgentLink> links = new ArrayList<>();

        try (RunningLeagueServer server = RunningLeagueServer.orSkip()) {
            server.match().addObserver(referee);
            RobotThreads robots = new RobotThreads();
            for (int number = 1; number <= PLAYERS; number++) {
                for (String team : List.of("Blue", "Red")) {
                    AgentLink link = server.connect();
                    links.add(link);
                    join(number, team, link, robots);
                }
            }
            server.match().order(new Order.KickOff(TeamSide.LEFT));
            boolean isOver = referee.over.await(1200, TimeUnit.SECONDS);
            links.forEach(AgentLink::close);
            robots.await();

            assertThat(isOver).as("a minute of open play").isTrue();
            assertThat(referee.leastRobots).as("robots on the pitch").isEqualTo(2 * PLAYERS);
            assertThat(referee.last.orElseThrow().robots()).allSatisfy(LeagueTeamTest::isOnItsSide);
        }
    }

    private static void isOnItsSide(RobotSnapshot robot) {
        assertThat(robot.side()).contains(robot.team().equals("Blue") ? TeamSide.LEFT : TeamSide.RIGHT);
    }

    /** Starts a robot and waits until it is in place. */
    private static void join(int number, String team, AgentLink link, RobotThreads robots) throws InterruptedException {
        CountDownLatch joined = new CountDownLatch(1);
        robots.start(() -> {
            AgentDriver driver = new AgentDriver(new Agent_Team(number));
            Options options = driver.defaultOptions().withTeam(team).overriddenBy("--robot", "T1");
            try (link) {
                driver.joinLeague(link, options);
                joined.countDown();
                driver.resume();
            } catch (IOException lost) {
                throw new UncheckedIOException(lost);
            } finally {
                joined.countDown();
            }
        });
        joined.await();
    }

    /** Counts the seconds of open play. */
    private static final class Referee implements SimulationObserver {

        private final CountDownLatch over = new CountDownLatch(1);
        private volatile int leastRobots = Integer.MAX_VALUE;
        private volatile Optional<WorldSnapshot> last = Optional.empty();
        private double secondsOfPlay;
        private double seconds;

        @Override
        public void cycleEnded(WorldSnapshot snapshot) {
            double now = snapshot.cycle() * Cycle.SECONDS;
            if (snapshot.playMode() == PlayMode.PLAY_ON) {
                secondsOfPlay += now - seconds;
                leastRobots = Math.min(leastRobots, snapshot.robots().size());
            }
            seconds = now;
            last = Optional.of(snapshot);
            if (secondsOfPlay > SECONDS) {
                over.countDown();
            }
        }
    }
}
