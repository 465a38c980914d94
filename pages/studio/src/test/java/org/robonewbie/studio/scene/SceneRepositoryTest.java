package org.robonewbie.studio.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.state.WorldState;

class SceneRepositoryTest {

    private final SteppedSimulator world = SteppedSimulator.start(WorldSettings.beginner(), Console.silent());
    private final Map<String, byte[]> kept = new HashMap<>();
    private final SceneRepository repository = new SceneRepository(new SceneRepository.Keeper() {

        @Override
        public void keep(String name, byte[] scene) {
            kept.put(name, scene);
        }

        @Override
        public void forget(String name) {
            kept.remove(name);
        }
    });
    private final List<UndoableCommand> done = new ArrayList<>();
    private final SceneService service = new SceneService(repository, "a test", new StandingWorld(), done::add);

    private final class StandingWorld implements RestorableSimulation {

        @Override
        public SoccerField field() {
            return SoccerField.BEGINNER;
        }

        @Override
        public WorldSnapshot now() {
            return world.snapshot(true, 1);
        }

        @Override
        public Optional<WorldState> save() {
            return Optional.of(world.save());
        }

        @Override
        public Restored restore(Checkpoint moment) {
            moment.exact().ifPresent(world::resumeFrom);
            return new Restored(moment.exact().isPresent(), 0);
        }
    }

    @BeforeEach
    void putTheBallSomewhere() {
        world.order(new Order.MoveBall(new Vector3(1.23456789, 2, 0.042), Vector3.ZERO));
        world.cycle();
    }

    @Test
    void sceneIsRestoredExactlyFromTheBackingStore() throws IOException {
        Vector3 before = world.snapshot(true, 1).ballPosition();
        ask("PUT", "Corner");
        world.order(new Order.MoveBall(Vector3.ZERO, Vector3.ZERO));

        repository.clear();
        kept.forEach(repository::take);

        assertThat(ask("POST", "Corner")).isEqualTo("{\"exact\":true,\"agents\":0}");
        assertThat(world.snapshot(true, 1).ballPosition()).isEqualTo(before);
    }

    @Test
    void stateOfAnotherVersionIsRestoredApproximately() throws IOException {
        service.answer("PUT", "Corner", Optional.empty(), false);
        byte[] scene = Objects.requireNonNull(kept.get("Corner"));
        int version = indexOf(scene, "RNSTATE") + "RNSTATE".length();
        scene[version]++;
        repository.take("Corner", scene);

        assertThat(ask("POST", "Corner")).isEqualTo("{\"exact\":false,\"agents\":0}");
        assertThat(repository.load("Corner").state().ballPosition().x()).isBetween(1.23, 1.24);
    }

    @Test
    void deletedAndRenamedScenesComeBackByUndo() throws IOException {
        ask("PUT", "Corner");
        service.answer("PUT", "Free kick", Optional.of("Corner"), false);
        ask("DELETE", "Free kick");
        assertThat(kept).isEmpty();

        assertThat(done)
                .extracting(UndoableCommand::name)
                .containsExactly("scene \"Corner\" renamed to \"Free kick\"", "scene \"Free kick\" deleted");
        done.get(1).undo();
        done.get(0).undo();

        assertThat(kept).containsOnlyKeys("Corner");
        assertThat(ask("GET", "")).isEqualTo("{\"scenes\":[\"Corner\"],\"folder\":\"a test\"}");
    }

    @Test
    void nameThatIsTakenAndSceneThatIsGoneOrDamagedAreRefused() throws IOException {
        ask("PUT", "Corner");
        repository.take("Broken", new byte[] {1, 2, 3});

        assertThatThrownBy(() -> ask("PUT", "Corner"))
                .hasMessage("There is already a scene named \"Corner\". Choose another name.");
        assertThatThrownBy(() -> ask("POST", "Kick"))
                .hasMessage("The scene \"Kick\" no longer exists. Reload the page.");
        assertThatThrownBy(() -> ask("DELETE", "Kick"))
                .hasMessage("The scene \"Kick\" no longer exists. Reload the page.");
        assertThatThrownBy(() -> ask("POST", "Broken")).hasMessage("The scene \"Broken\" is damaged.");
    }

    @Test
    void recordingWithoutTheMomentIsRefused() throws IOException {
        ByteArrayOutputStream recorded = new ByteArrayOutputStream();
        SceneRecording.write(new Target(recorded), SoccerField.BEGINNER, world.snapshot(true, 1));
        byte[] bytes = recorded.toByteArray();

        assertThat(service.start(recording(bytes), 0, SceneService.ENDS_BEFORE))
                .isEqualTo("{\"exact\":false,\"agents\":0}");
        assertThatThrownBy(() -> service.start(recording(bytes), 1, SceneService.ENDS_BEFORE))
                .hasMessage(
                        "The recording has no cycle 1: it ends earlier, or is damaged at that point. Choose an earlier cycle.");
        assertThatThrownBy(() -> recording(new byte[9])).hasMessageStartingWith("This is not a RoboNewbie recording");
    }

    private static RecordingReader recording(byte[] bytes) throws IOException {
        return RecordingReader.ofUnpacked(new ByteArrayInputStream(bytes), "This");
    }

    private record Target(ByteArrayOutputStream content) implements RecordingTarget {

        @Override
        public void write(byte[] bytes, int length) {
            content.write(bytes, 0, length);
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
    }

    private String ask(String method, String name) throws IOException {
        return service.answer(method, name, Optional.empty(), false);
    }

    private static int indexOf(byte[] bytes, String word) {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        return text.indexOf(word);
    }
}
