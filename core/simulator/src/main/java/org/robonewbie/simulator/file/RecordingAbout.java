package org.robonewbie.simulator.file;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.simulator.json.Json;

/**
 * The metadata of a recording in a sidecar file {@code NAME.about}: its origin and the user's annotations. The recording
 * itself does not contain this metadata, so that identical runs produce identical recordings.
 *
 * @param agent name of the program, empty if unknown
 * @param project working directory of the program, empty if unknown
 * @param starred whether the recording is exempt from automatic deletion
 * @param bookmarks the user's bookmarks, earliest first
 */
public record RecordingAbout(String agent, String project, boolean starred, List<Bookmark> bookmarks) {

    /** The metadata of a recording without a sidecar file. */
    public static final RecordingAbout NOTHING = new RecordingAbout("", "", false, List.of());

    private static final int MAX_NOTE_LETTERS = 300;
    private static final int MAX_BOOKMARKS = 500;
    private static final int MAX_BYTES = 1 << 20;

    /**
     * A bookmark.
     *
     * @param seconds time since the start of the recording
     * @param note the user's note, may be empty
     */
    public record Bookmark(double seconds, String note) {}

    /** Makes the list of bookmarks unmodifiable. */
    public RecordingAbout {
        bookmarks = List.copyOf(bookmarks);
    }

    /**
     * Reads the metadata of a recording.
     *
     * @param recording the recording file
     * @return the metadata; {@link #NOTHING} if the sidecar file is missing or damaged
     */
    public static RecordingAbout of(Path recording) {
        try {
            Path file = new RecordingGroup(recording).beside(RecordingGroup.ABOUT);
            String text = new String(RegularFile.read(file, MAX_BYTES), StandardCharsets.UTF_8);
            return of(JsonParser.parseString(text).getAsJsonObject());
        } catch (IOException | RuntimeException none) {
            return NOTHING;
        }
    }

    /**
     * Reads metadata from JSON.
     *
     * @param json an object as returned by {@link #json}; members may be missing
     * @return the metadata
     * @throws RuntimeException if a member has the wrong type
     */
    public static RecordingAbout of(JsonObject json) {
        List<Bookmark> bookmarks = new ArrayList<>();
        if (json.has("bookmarks")) {
            for (JsonElement each : json.getAsJsonArray("bookmarks")) {
                bookmarks.add(new Bookmark(
                        each.getAsJsonObject().get("seconds").getAsDouble(), text(each.getAsJsonObject(), "note")));
            }
        }
        boolean isStarred = json.has("starred") && json.get("starred").getAsBoolean();
        return new RecordingAbout(text(json, "agent"), text(json, "project"), isStarred, bookmarks);
    }

    private static String text(JsonObject json, String name) {
        return json.has(name) ? json.get(name).getAsString() : "";
    }

    /** {@return the metadata as JSON} */
    public JsonObject json() {
        return Json.object(
                "agent", agent,
                "project", project,
                "starred", starred,
                "bookmarks",
                        Json.array(bookmarks.stream()
                                .map(each -> Json.object("seconds", each.seconds(), "note", each.note()))));
    }

    /**
     * Writes the sidecar file of a recording.
     *
     * @param recording the recording file
     * @throws IOException if it cannot be written
     */
    public void write(Path recording) throws IOException {
        AtomicFile.write(new RecordingGroup(recording).beside(RecordingGroup.ABOUT), json().toString());
    }

    /**
     * Adds or removes the star.
     *
     * @param isStarred whether the recording is exempt from automatic deletion
     * @return a modified copy
     */
    public RecordingAbout withStar(boolean isStarred) {
        return new RecordingAbout(agent, project, isStarred, bookmarks);
    }

    /**
     * Adds a bookmark, replacing an existing one with the same time.
     *
     * @param seconds time since the start of the recording
     * @param note the user's note, truncated to 300 characters
     * @return a modified copy
     * @throws IllegalArgumentException if there are already 500 bookmarks; the message can be shown to the user
     */
    public RecordingAbout withBookmark(double seconds, String note) {
        List<Bookmark> all = new ArrayList<>(withoutBookmark(seconds).bookmarks());
        if (all.size() >= MAX_BOOKMARKS) {
            throw new IllegalArgumentException("A recording can have at most " + MAX_BOOKMARKS
                    + " bookmarks. Delete one that is no longer needed.");
        }
        all.add(new Bookmark(seconds, note.substring(0, Math.min(note.length(), MAX_NOTE_LETTERS))));
        all.sort(Comparator.comparingDouble(Bookmark::seconds));
        return new RecordingAbout(agent, project, starred, all);
    }

    /**
     * Removes a bookmark.
     *
     * @param seconds time of the bookmark
     * @return a modified copy
     */
    public RecordingAbout withoutBookmark(double seconds) {
        return new RecordingAbout(
                agent,
                project,
                starred,
                bookmarks.stream().filter(each -> each.seconds() != seconds).toList());
    }
}
