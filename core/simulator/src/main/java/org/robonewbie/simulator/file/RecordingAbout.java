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
 * What is known of a recording beside what it holds, kept next to it as {@code NAME.about}: where it comes from, and what people
 * have noted. The recording itself is the same for the same seed, whoever made it.
 *
 * @param agent name of the program that was run, empty if it is not known
 * @param project folder in which it was run, empty if it is not known
 * @param starred whether it is to be kept when recordings make room
 * @param bookmarks moments that are worth coming back to, the earliest first
 */
public record RecordingAbout(String agent, String project, boolean starred, List<Bookmark> bookmarks) {

    /** What is known of a recording of which nobody has said anything. */
    public static final RecordingAbout NOTHING = new RecordingAbout("", "", false, List.of());

    private static final int MAX_NOTE_LETTERS = 300;
    private static final int MAX_BOOKMARKS = 500;
    private static final int MAX_BYTES = 1 << 20;

    /**
     * A moment with a note.
     *
     * @param seconds since the begin of the recording
     * @param note what is to be seen there, may be empty
     */
    public record Bookmark(double seconds, String note) {}

    /** What a file holds; what is missing there is null. */
    private record Written(
            @Nullable String agent,
            @Nullable String project,
            boolean starred,
            @Nullable List<Bookmark> bookmarks) {}

    /** Makes the list unmodifiable. */
    public RecordingAbout {
        bookmarks = List.copyOf(bookmarks);
    }

    /**
     * Reads what is known of a recording.
     *
     * @param recording its file
     * @return what is known; {@link #NOTHING} if there is no such file, or a damaged one
     */
    public static RecordingAbout of(Path recording) {
        try {
            Path file = RecordingGroup.of(recording).beside(RecordingGroup.ABOUT);
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
     * Keeps this beside a recording.
     *
     * @param recording its file
     * @throws IOException if it cannot be written
     */
    public void write(Path recording) throws IOException {
        AtomicFile.write(RecordingGroup.of(recording).beside(RecordingGroup.ABOUT), new Gson().toJson(this));
    }

    /**
     * Changes the star.
     *
     * @param isStarred whether it is to be kept
     * @return the same with or without a star
     */
    public RecordingAbout withStar(boolean isStarred) {
        return new RecordingAbout(agent, project, isStarred, bookmarks);
    }

    /**
     * Adds a bookmark, in the place of one at the same moment.
     *
     * @param seconds since the begin of the recording
     * @param note what is to be seen there; cut after 300 letters
     * @return the same with the bookmark
     * @throws IllegalArgumentException if there are 500 bookmarks already; the message is meant for people
     */
    public RecordingAbout withBookmark(double seconds, String note) {
        List<Bookmark> all = new ArrayList<>(withoutBookmark(seconds).bookmarks());
        if (all.size() >= MAX_BOOKMARKS) {
            throw new IllegalArgumentException(
                    "A recording has " + MAX_BOOKMARKS + " bookmarks at most. Delete one that is not needed any more.");
        }
        all.add(new Bookmark(seconds, note.substring(0, Math.min(note.length(), MAX_NOTE_LETTERS))));
        all.sort(Comparator.comparingDouble(Bookmark::seconds));
        return new RecordingAbout(agent, project, starred, all);
    }

    /**
     * Takes a bookmark away.
     *
     * @param seconds its moment
     * @return the same without it
     */
    public RecordingAbout withoutBookmark(double seconds) {
        return new RecordingAbout(
                agent,
                project,
                starred,
                bookmarks.stream().filter(each -> each.seconds() != seconds).toList());
    }
}
