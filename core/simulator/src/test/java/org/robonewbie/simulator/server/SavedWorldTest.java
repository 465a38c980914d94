package org.robonewbie.simulator.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;
import org.robonewbie.simulator.world.SoccerWorld;

/** A running simulation goes on from a state that was saved while it ran, whose agents play on. */
@Timeout(120)
class SavedWorldTest {

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

    private void exchange(int cycles, String commands) throws IOException {
        for (int i = 0; i < cycles; i++) {
            agent.exchange(commands + "(syn)");
        }
    }

    /** Carries a request out, which happens between two cycles. */
    private <T> T during(Consumer<Consumer<T>> request) throws IOException {
        CompletableFuture<T> answer = new CompletableFuture<>();
        request.accept(answer::complete);
        while (!answer.isDone()) {
            agent.exchange("(syn)");
        }
        return answer.join();
    }

    private WorldState save() throws IOException {
        return this.<Optional<WorldState>>during(server.control()::save).orElseThrow();
    }

    private OptionalInt restore(WorldState state) throws IOException {
        return during(receiver -> server.control().restore(state, receiver));
    }

    @Test
    void theWorldGoesOnToTheBitButItsCyclesAreCountedOn() throws IOException {
        exchange(12, "(lle5 3)(rle5 3)");
        WorldState falling = save();
        exchange(60, "(lle5 0)(rle5 0)");

        assertThat(restore(falling)).hasValue(0);
        exchange(2, "");

        WorldSnapshot again = firstAfterTheLeap();
        WorldSnapshot original = seen.stream()
                .filter(each -> each.gameTime() == again.gameTime())
                .findFirst()
                .orElseThrow();
        assertThat(again.cycle()).isGreaterThan(original.cycle() + 50);
        assertThat(numbers(again)).isEqualTo(numbers(original));
    }

    private WorldSnapshot firstAfterTheLeap() {
        for (int i = 1; i < seen.size(); i++) {
            if (seen.get(i).gameTime() < seen.get(i - 1).gameTime()) {
                return seen.get(i);
            }
        }
        throw new AssertionError("The world did not go back.");
    }

    /** Lists what one sees of the ball and the only robot. */
    private static List<Object> numbers(WorldSnapshot snapshot) {
        BodyState body = snapshot.robots().get(0).body();
        List<Object> numbers = new ArrayList<>(List.of(
                snapshot.robots().get(0).id(),
                snapshot.ballPosition(),
                snapshot.ballRotation(),
                body.torso().position(),
                body.torso().rotation()));
        for (double degrees : body.hingeDegrees()) {
            numbers.add(degrees);
        }
        return numbers;
    }

    @Test
    void aStateOfAnotherWorldIsRefused() throws IOException {
        WorldState other = new SoccerWorld(SoccerField.BEGINNER).save();

        assertThat(restore(other)).isEmpty();
    }
}
