package org.robonewbie.simulator.file;

import com.google.gson.Gson;
import com.google.gson.JsonParseException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.RegularFile;

/**
 * The metadata of a recording in a sidecar file {@code NAME.about}: its origin and the user's annotations. The recording
 * itself contains none of it, so that identical runs produce identical recordings.
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

    /** The contents of a file; missing values are null. */
    private record Written(
            @Nullable String agent,
            @Nullable String project,
            boolean starred,
            @Nullable List<Bookmark> bookmarks) {}

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
            Written written = new Gson()
                    .fromJson(new String(RegularFile.read(file, MAX_BYTES), StandardCharsets.UTF_8), Written.class);
            return new RecordingAbout(
                    Optional.ofNullable(written.agent()).orElse(""),
                    Optional.ofNullable(written.project()).orElse(""),
                    written.starred(),
                    Optional.ofNullable(written.bookmarks()).orElse(List.of()));
        } catch (IOException | JsonParseException | NullPointerException none) {
            return NOTHING;
        }
    }

    /**
     * Writes the sidecar file of a recording.
     *
     * @param recording the recording file
     * @throws IOException if it cannot be written
     */
    public void write(Path recording) throws IOException {
        AtomicFile.write(new RecordingGroup(recording).beside(RecordingGroup.ABOUT), new Gson().toJson(this));
    }

    /**
     * Adds or removes the star.
     *
     * @param isStarred whether the recording is exempt from automatic deletion
     * @return a changed copy
     */
    public RecordingAbout withStar(boolean isStarred) {
        return new RecordingAbout(agent, project, isStarred, bookmarks);
    }

    /**
     * Adds a bookmark, replacing any at the same time.
     *
     * @param seconds time since the start of the recording
     * @param note the user's note, truncated to 300 characters
     * @return a changed copy
     * @throws IllegalArgumentException if there are already 500 bookmarks; the message is suitable for the user
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
     * @param seconds its time
     * @return a changed copy
     */
    public RecordingAbout withoutBookmark(double seconds) {
        return new RecordingAbout(
                agent,
                project,
                starred,
                bookmarks.stream().filter(each -> each.seconds() != seconds).toList());
    }
}
