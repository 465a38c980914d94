package org.robonewbie.studio.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Makes the cards of recordings, each only once while its file does not change. */
final class RecordingCards {

    private final Map<Path, Known> cards = new ConcurrentHashMap<>();

    private record Known(FileTime modified, String json) {}

    /** {@return the card of a recording as JSON} */
    String of(Path recording) throws IOException {
        FileTime modified = Files.getLastModifiedTime(recording);
        Known known = cards.get(recording);
        if (known == null || !known.modified().equals(modified)) {
            known = new Known(modified, RecordingCard.of(recording).json());
            cards.put(recording, known);
        }
        return known.json();
    }
}
