package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.soccer.MatchEvent;

@Timeout(120)
class RestorationTest {

    private static final int FALLING_CYCLES = 25;

    private final List<WorldSnapshot> seen = new CopyOnWriteArrayList<>();
    private LeagueServer server;
    private TestAgent agent;

    @BeforeEach
    void start() throws IOException {
        server = new LeagueServer();
        agent = server.joinPlay(seen::add);
    }

    @AfterEach
    void end() throws IOException {
        server.close();
    }

    private WorldSnapshot latest() {
        return seen.get(seen.size() - 1);
    }

    private WorldSnapshot after(int cycles, String commands) throws IOException {
        for (int i = 0; i < cycles; i++) {
            agent.exchange(commands + "(syn)");
        }
        return latest();
    }

    /** Finds the moment that came as long after the restored one. */
    private WorldSnapshot afterSameTime(WorldSnapshot first) throws IOException {
        after(40, "");
        List<WorldSnapshot> same = seen.stream()
                .filter(snapshot -> Math.abs(snapshot.gameTime() - first.gameTime()) < 1e-6)
                .toList();
        assertThat(same).hasSizeGreaterThan(1);
        return same.get(same.size() - 1);
    }

    @Test
    void fallingRobotGoesOnFalling() throws IOException {
        WorldSnapshot before = after(12, "(lle5 3)(rle5 3)");
        WorldSnapshot moment = after(2, "(lle5 0)(rle5 0)");
        WorldSnapshot fallen = after(FALLING_CYCLES, "(lle5 0)(rle5 0)");
        after(60, "");

        server.control().restore(before, moment);
        WorldSnapshot again = afterSameTime(fallen);

        for (int axis = 0; axis < 3; axis++) {
            assertThat(torso(again, axis)).isEqualTo(torso(fallen, axis), within(0.03));
        }
        assertThat(torso(fallen, 2)).isLessThan(torso(moment, 2) - 0.05f);
    }

    @Test
    void rollingBallAndScoreComeBack() throws IOException {
        server.control().order(new Order.MoveBall(new Vector3(1, 1, 0.042), new Vector3(2, 0, 0)));
        WorldSnapshot before = after(2, "");
        WorldSnapshot moment = after(2, "");
        WorldSnapshot rolled = after(20, "");
        server.control().order(new Order.MoveBall(new Vector3(15.2, 0, 0.1), Vector3.ZERO));
        assertThat(after(3, "").scoreLeft()).isEqualTo(1);

        server.control().restore(before, moment);
        WorldSnapshot again = afterSameTime(rolled);

        assertThat(again.scoreLeft()).isZero();
        assertThat(again.playMode()).isEqualTo(PlayMode.PLAY_ON);
        assertThat(again.ballPosition().x()).isEqualTo(rolled.ballPosition().x(), within(0.03));
        assertThat(again.ballPosition().x()).isGreaterThan(moment.ballPosition().x() + 0.3);
    }

    @Test
    void restingStateHasNoVelocities() throws IOException {
        WorldSnapshot standing = latest();
        after(60, "(lle5 3)(rle5 3)");

        server.control().restore(standing, standing);
        WorldSnapshot again = after(30, "");

        assertThat(torso(again, 2)).isEqualTo(torso(standing, 2), within(0.01));
    }

    @Test
    void observersHearOfGoals() throws IOException {
        List<MatchEvent> events = new CopyOnWriteArrayList<>();
        server.control().addObserver(new SimulationObserver() {
            @Override
            public void cycleEnded(WorldSnapshot snapshot) {}

            @Override
            public void happened(MatchEvent event) {
                events.add(event);
            }
        });

        server.control().order(new Order.MoveBall(new Vector3(15.2, 0, 0.1), Vector3.ZERO));
        after(3, "");

        assertThat(events).contains(new MatchEvent.GoalScored(TeamSide.LEFT, "Ada"));
    }

    private static double torso(WorldSnapshot snapshot, int axis) {
        Vector3 torso = snapshot.robots().get(0).body().position();
        return axis == 0 ? torso.x() : axis == 1 ? torso.y() : torso.z();
    }
}
