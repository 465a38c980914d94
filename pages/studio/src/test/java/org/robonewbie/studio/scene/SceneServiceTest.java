package org.robonewbie.studio.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.cycle.SteppedSimulator;
import org.robonewbie.simulator.cycle.WorldSettings;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.simulator.state.WorldState;

class SceneServiceTest {

    private final SteppedSimulator world = SteppedSimulator.start(WorldSettings.beginner(), Console.silent());
    private final Map<String, byte[]> kept = new TreeMap<>();
    private final List<UndoableCommand> done = new ArrayList<>();
    private final SceneService service = new SceneService(new Memory(), "a test", new StandingWorld(), done::add);

    private final class Memory implements SceneStore {

        @Override
        public List<String> names() {
            return List.copyOf(kept.keySet());
        }

        @Override
        public SavedScene read(String name) {
            return SavedScene.of(Objects.requireNonNull(kept.get(name)));
        }

        @Override
        public void write(String name, SavedScene scene) {
            kept.put(name, scene.toBytes());
        }

        @Override
        public void delete(String name) {
            kept.remove(name);
        }
    }

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
    void sceneIsRestoredExactly() throws IOException {
        Vector3 before = world.snapshot(true, 1).ballPosition();
        ask("PUT", "Corner");
        world.order(new Order.MoveBall(Vector3.ZERO, Vector3.ZERO));

        assertThat(ask("POST", "Corner")).isEqualTo("{\"exact\":true,\"agents\":0}");
        assertThat(world.snapshot(true, 1).ballPosition()).isEqualTo(before);
    }

    @Test
    void stateOfAnotherVersionIsRestoredApproximately() throws IOException {
        ask("PUT", "Corner");
        byte[] scene = Objects.requireNonNull(kept.get("Corner"));
        int version = indexOf(scene, "RNSTATE") + "RNSTATE".length();
        scene[version]++;

        assertThat(ask("POST", "Corner")).isEqualTo("{\"exact\":false,\"agents\":0}");
        assertThat(SavedScene.of(scene)
                        .checkpoint()
                        .orElseThrow()
                        .state()
                        .ballPosition()
                        .x())
                .isBetween(1.23, 1.24);
    }

    @Test
    void deletedAndRenamedScenesComeBackByUndo() throws IOException {
        ask("PUT", "Corner");
        ask("PUT", "Free kick", "was", "Corner");
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
        kept.put("Broken", new byte[] {1, 2, 3});

        assertThatThrownBy(() -> ask("PUT", "corner"))
                .hasMessage("There is already a scene named \"corner\". Choose another name.");
        assertThatThrownBy(() -> ask("PUT", "Corner"))
                .hasMessage("There is already a scene named \"Corner\". Choose another name.");
        assertThatThrownBy(() -> ask("POST", "Kick"))
                .hasMessage("The scene \"Kick\" no longer exists. Reload the page.");
        assertThatThrownBy(() -> ask("DELETE", "Kick"))
                .hasMessage("The scene \"Kick\" no longer exists. Reload the page.");
        assertThatThrownBy(() -> ask("PUT", "Free kick", "was", "Kick"))
                .hasMessage("The scene \"Kick\" no longer exists. Reload the page.");
        assertThatThrownBy(() -> ask("PUT", "../out"))
                .hasMessageStartingWith("A scene cannot be named \"../out\". Use letters");
        assertThatThrownBy(() -> ask("POST", "Broken")).hasMessage("The scene \"Broken\" is damaged.");
    }

    @Test
    void sceneIsReplacedOnRequestOnly() throws IOException {
        ask("PUT", "Corner");
        byte[] before = Objects.requireNonNull(kept.get("Corner"));
        world.cycle();

        ask("PUT", "Corner", "replace", "yes");

        assertThat(kept.get("Corner")).isNotEqualTo(before);
    }

    @Test
    void folderKeepsAScene(@TempDir Path folder) throws IOException {
        SceneFolder store = new SceneFolder(folder.resolve("scenes"));
        SavedScene scene = SavedScene.of(SoccerField.BEGINNER, world.snapshot(true, 1), Optional.of(world.save()));

        store.write("Corner", scene);

        assertThat(store.names()).containsExactly("Corner");
        assertThat(store.read("Corner").toBytes()).isEqualTo(scene.toBytes());
        store.write("Corner", new SavedScene(scene.recording(), new byte[0]));
        assertThat(store.read("Corner").exact()).isEmpty();
        store.delete("Corner");
        assertThat(folder.resolve("scenes")).isEmptyDirectory();
    }

    @Test
    void linkToAnotherPlaceIsNoScene(@TempDir Path folder) throws IOException {
        Path secret = Files.writeString(folder.resolve("secret"), "hush");
        SceneFolder store = new SceneFolder(Files.createDirectory(folder.resolve("scenes")));
        Files.createSymbolicLink(store.folder().resolve("Corner.rec"), secret);

        assertThat(store.names()).isEmpty();
        assertThatThrownBy(() -> store.write("Corner", new SavedScene(new byte[0], new byte[0])))
                .hasMessageStartingWith("The scene \"Corner\" is a link or folder in ");
        assertThat(secret).hasContent("hush");
    }

    @Test
    void recordingWithoutTheMomentIsRefused() throws IOException {
        byte[] bytes = SavedScene.of(SoccerField.BEGINNER, world.snapshot(true, 1), Optional.empty())
                .recording();

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

    private String ask(String method, String name, String... parameter) throws IOException {
        return service.answer(method, List.of(name), each -> List.of(parameter).contains(each) ? parameter[1] : "");
    }

    private static int indexOf(byte[] bytes, String word) {
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        return text.indexOf(word);
    }
}
