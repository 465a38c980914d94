package org.robonewbie.studio.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.simulator.file.RecordingAbout;

class ReplayServiceTest {

    private static final String SUMMARY =
            "{\"count\":9,\"events\":[{\"index\":3,\"kind\":\"goal\",\"text\":\"left\"}],\"rosters\":[],\"header\":{}}";

    private final Map<String, RecordingEntry> recordings = new LinkedHashMap<>();
    private final Map<String, RecordingEntry> bin = new LinkedHashMap<>();
    private final ReplayService service = new ReplayService(new RecordingStore() {

        @Override
        public List<RecordingEntry> all() {
            return List.copyOf(recordings.values());
        }

        @Override
        public Optional<String> folder() {
            return Optional.of("a test");
        }

        @Override
        public void write(String name, RecordingAbout about) {
            record(name, false, about);
        }

        private RecordingEntry taken(String name) {
            return Objects.requireNonNull(recordings.remove(name));
        }

        @Override
        public void rename(String from, String to) {
            record(to, false, taken(from).about());
        }

        @Override
        public void remove(String name) {
            bin.put(name, taken(name));
        }

        @Override
        public boolean bringBack(String name) {
            return bin.containsKey(name) && recordings.put(name, Objects.requireNonNull(bin.remove(name))) == null;
        }

        @Override
        public RunReading read(String name, long milliseconds) {
            return new RunReading(JsonParser.parseString(SUMMARY).getAsJsonObject(), false, List.of(0, 5));
        }
    });

    private void record(String name, boolean running, RecordingAbout about) {
        recordings.put(name, new RecordingEntry(name, 42, running, true, about));
    }

    @BeforeEach
    void record() {
        record("game", false, RecordingAbout.NOTHING);
        record("other", false, RecordingAbout.NOTHING);
    }

    /** Asks the service; each parameter is its name, an equals sign and its value. */
    private String ask(String request, String... parameters) throws IOException {
        List<String> path = List.of(request.split(" ", 2)[1].split("/", -1));
        return service.answer(
                request.split(" ", 2)[0],
                path,
                name -> Arrays.stream(parameters)
                        .filter(each -> each.startsWith(name + "="))
                        .map(each -> each.substring(name.length() + 1))
                        .findFirst()
                        .orElse(""));
    }

    private RecordingAbout about() {
        return Objects.requireNonNull(recordings.get("game")).about();
    }

    @Test
    void recordingIsListedWithItsMetadata() throws IOException {
        recordings.remove("other");
        ask("PUT stars/game");

        assertThat(ask("GET recordings"))
                .isEqualTo("{\"recordings\":[{\"agent\":\"\",\"starred\":true,\"bookmarks\":[],\"name\":\"game\","
                        + "\"bytes\":42,\"running\":false,\"ofProject\":true}],\"folder\":\"a test\"}");
        ask("DELETE stars/game");
        assertThat(about().starred()).isFalse();
    }

    @Test
    void cardIsTheSummaryWithoutWhatOnlyAnOpenRecordingNeeds() throws IOException {
        assertThat(ask("GET cards/game"))
                .isEqualTo("{\"count\":9,\"events\":[{\"index\":3,\"kind\":\"goal\",\"text\":\"left\"}]}");
    }

    @Test
    void indexIsFollowedByItsGrowth() throws IOException {
        assertThat(ask("GET index/game")).contains("\"header\":{}", "\"whole\":false", "\"pieces\":[0,5]", "goal");
        assertThat(ask("GET index/game", "events=0", "pieces=1"))
                .isEqualTo("{\"count\":9,\"whole\":false,"
                        + "\"events\":[{\"index\":3,\"kind\":\"goal\",\"text\":\"left\"}],\"pieces\":[5]}");
        assertThat(ask("GET index/game", "events=7", "pieces=7"))
                .isEqualTo("{\"count\":9,\"whole\":false,\"events\":[],\"pieces\":[]}");
    }

    @Test
    void recordingIsRenamedToAnUnusedName() throws IOException {
        ask("PUT recordings/Finale (2)", "was=game");

        assertThat(recordings).containsOnlyKeys("other", "Finale (2)");
        assertThatThrownBy(() -> ask("PUT recordings/other", "was=Finale (2)"))
                .hasMessage("There is already a recording named \"other\". Choose another name.");
        assertThat(ask("PUT recordings/other", "was=other")).isEqualTo("{}");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", " ", "../out", "CON", "goal.", "goal.rec", "goal.part", "goal?"})
    void invalidNameIsRefused(String name) {
        assertThatThrownBy(() -> ask("PUT recordings/" + name, "was=game"))
                .hasMessageStartingWith("A recording cannot be named \"" + name + "\". Use at most 80 letters");
    }

    @Test
    void deletedRecordingIsRestoredUnlessItsNameIsUsed() throws IOException {
        ask("DELETE recordings/game");
        assertThat(recordings).containsOnlyKeys("other");

        ask("PUT recordings/game", "removed=yes");

        assertThat(recordings).containsKey("game");
        assertThatThrownBy(() -> ask("PUT recordings/game", "removed=yes"))
                .hasMessage("There is already a recording named \"game\". Choose another name.");
        assertThatThrownBy(() -> ask("PUT recordings/lost", "removed=yes"))
                .hasMessage("The recording \"lost\" cannot be restored: it was deleted more than an hour ago.");
    }

    @Test
    void runningRecordingIsNeitherRenamedNorDeleted() {
        record("game", true, RecordingAbout.NOTHING);

        String refusal = "\"game\" is still being recorded. Stop the run first, or reset it in the Field room.";
        assertThatThrownBy(() -> ask("DELETE recordings/game")).hasMessage(refusal);
        assertThatThrownBy(() -> ask("PUT recordings/new", "was=game")).hasMessage(refusal);
    }

    @Test
    void missingRecordingIsRefused() {
        for (String request : List.of("GET cards/lost", "GET index/lost", "PUT stars/lost", "DELETE recordings/lost")) {
            assertThatThrownBy(() -> ask(request)).hasMessage("This recording no longer exists. Choose another one.");
        }
    }

    @Test
    void bookmarksAreSortedAndReplaceEachOther() throws IOException {
        ask("PUT bookmarks/game", "seconds=2.5", "note=later");
        ask("PUT bookmarks/game", "seconds=1", "note=" + "x".repeat(400));
        ask("PUT bookmarks/game", "seconds=2.5", "note=goal");

        assertThat(about().bookmarks())
                .containsExactly(
                        new RecordingAbout.Bookmark(1, "x".repeat(300)), new RecordingAbout.Bookmark(2.5, "goal"));
        ask("DELETE bookmarks/game", "seconds=2.5");
        assertThat(about().bookmarks()).hasSize(1);
        assertThatThrownBy(() -> ask("PUT bookmarks/game", "seconds=soon"))
                .hasMessage("The time of the bookmark is missing. Reload the page.");
    }

    @Test
    void bookmarksAreLimited() throws IOException {
        for (int seconds = 0; seconds < 500; seconds++) {
            ask("PUT bookmarks/game", "seconds=" + seconds);
        }

        ask("PUT bookmarks/game", "seconds=7", "note=replaced");

        assertThatThrownBy(() -> ask("PUT bookmarks/game", "seconds=500"))
                .hasMessage("A recording can have at most 500 bookmarks. Delete one that is no longer needed.");
    }
}
