package org.robonewbie.studio.replay;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.robonewbie.simulator.file.RecordingGroup;

/** LRU cache of recording indexes. */
final class RecordingIndexes {

    private static final int CAPACITY = 40;

    private final Map<Path, RecordingIndex> known = new LinkedHashMap<>(CAPACITY, 0.75f, true);

    /** {@return the index of a recording, which may be incomplete} */
    RecordingIndex of(Path recording) throws IOException {
        Path key = new RecordingGroup(recording).beside("");
        synchronized (known) {
            RecordingIndex index = known.get(key);
            if (index != null && index.fits(recording)) {
                return index;
            }
        }
        RecordingIndex fresh = RecordingIndex.open(recording);
        synchronized (known) {
            known.put(key, fresh);
            while (known.size() > CAPACITY) {
                known.remove(known.keySet().iterator().next());
            }
        }
        return fresh;
    }
}
