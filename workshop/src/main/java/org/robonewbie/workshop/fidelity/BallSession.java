package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.order.Order.ChangePlayMode;
import org.robonewbie.protocol.order.Order.MoveBall;
import org.robonewbie.protocol.order.Order.SetTime;
import org.robonewbie.simulator.world.BallProperties;

/**
 * Sets the ball in motion with trainer commands and records it through the monitor port. An idle robot replies to every message to keep the
 * server advancing.
 *
 * <p>A monitor cannot tell in which cycle its command takes effect. The ball therefore waits near the centre line, and a case starts with
 * the first message that shows it elsewhere, even if the scene is partial. Messages are assigned to cycles by the game clock.
 */
final class BallSession {

    private static final double RADIUS = BallProperties.STANDARD.radius();
    private static final Vector3 WAITING_PLACE = new Vector3(0, 5, RADIUS);
    private static final double NOT_WAITING = 4;
    private static final int CYCLES_TO_WAIT = 10;

    private final ReferenceSession session;
    private final MonitorFeed monitor;

    BallSession(ReferenceSession session, MonitorFeed monitor) {
        this.session = session;
        this.monitor = monitor;
    }

    /**
     * Records one case. Returns one line per cycle, with the ball's position if the monitor received a full scene in that cycle.
     */
    List<String> record(BallCase ballCase) throws IOException {
        put(WAITING_PLACE, Vector3.ZERO);
        pass(CYCLES_TO_WAIT);
        int start = monitor.count();
        BallStart ball = BallStart.of(ballCase.name(), RADIUS);
        put(ball.position(), ball.velocity());
        pass(ballCase.cycles() + CYCLES_TO_WAIT);
        List<String> lines = new ArrayList<>();
        double first = Double.NaN;
        double last = Double.NEGATIVE_INFINITY;
        for (MonitorFeed.Sight sight : monitor.sightsFrom(start)) {
            MonitoredGame game = sight.game();
            if (lines.isEmpty() && !sight.ball().map(BallSession::hasLeft).orElse(false)) {
                continue;
            }
            if (lines.size() == ballCase.cycles() || game.timeSeconds() < last + Cycle.SECONDS / 2) {
                continue;
            }
            last = game.timeSeconds();
            first = lines.isEmpty() ? last : first;
            if (Math.round((last - first) / Cycle.SECONDS) != lines.size()) {
                throw new IOException(ReferenceSession.STEP_ADVICE);
            }
            lines.add(RowWriter.ballRow(ballCase, lines.size(), sight.ball().filter(place -> sight.isFull()), game));
        }
        if (lines.size() < ballCase.cycles()) {
            throw new IOException(ReferenceSession.STEP_ADVICE);
        }
        return lines;
    }

    private static boolean hasLeft(Vector3 ball) {
        return ball.y() < NOT_WAITING;
    }

    private void put(Vector3 place, Vector3 velocity) throws IOException {
        monitor.send(
                new SetTime(0),
                new ChangePlayMode(PlayMode.PLAY_ON),
                new MoveBall(Optional.of(place), Optional.of(velocity)));
    }

    private void pass(int cycles) throws IOException {
        for (int i = 0; i < cycles; i++) {
            int before = monitor.count();
            monitor.requestFullState();
            session.exchange("");
            if (!monitor.await(before + 1)) {
                throw new IOException(ReferenceSession.STEP_ADVICE);
            }
        }
    }
}
