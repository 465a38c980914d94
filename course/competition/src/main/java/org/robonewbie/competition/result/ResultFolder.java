package org.robonewbie.competition.result;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Results;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.trial.TrialFiles;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.Fingerprint;

/**
 * The folder in which a contest keeps everything: each finished trial in a file of its own, written atomically, so that an
 * interrupted contest continues where it was.
 */
public final class ResultFolder implements Results, AutoCloseable {

    /** The file that one contest at a time holds. */
    private static final String LOCK = "competition.lock";

    private final Path folder;
    private final FolderLock lock;
    private final Map<String, TrialJson.Kept> finished = new ConcurrentHashMap<>();
    private final Map<String, String> written = new ConcurrentHashMap<>();

    private ResultFolder(Path folder, FolderLock lock) {
        this.folder = folder;
        this.lock = lock;
    }

    /**
     * Opens a folder for one contest at a time.
     *
     * @param folder the folder; it is made if it does not exist
     * @return the open folder
     * @throws IOException if it cannot be written to
     * @throws CalledWronglyException if another program is using it
     */
    public static ResultFolder open(Path folder) throws IOException {
        for (String part : new String[] {"trials", "recordings", "logs", "work", "certificates"}) {
            Files.createDirectories(folder.resolve(part));
        }
        FolderLock lock = FolderLock.take(folder.resolve(LOCK))
                .orElseThrow(() -> new CalledWronglyException("Another competition is using the folder " + folder
                        + ". Wait for its end, or choose another folder with --results."));
        return new ResultFolder(folder, lock);
    }

    /**
     * Returns the path of a file of the results.
     *
     * @param name its name in this folder
     * @return the file
     */
    public Path file(String name) {
        return folder.resolve(name);
    }

    /**
     * Returns where a trial writes its files.
     *
     * @param trial the trial
     * @return its files
     */
    public TrialFiles filesOf(ContestTrial trial) {
        return new TrialFiles(Optional.of(recording(trial.id())), folder.resolve("logs"), folder.resolve("work"));
    }

    /**
     * Returns the recording of a trial.
     *
     * @param trialId name of the trial
     * @return the file, which {@code robonewbie studio} opens
     */
    public Path recording(String trialId) {
        return folder.resolve("recordings").resolve(trialId + ".rec");
    }

    /**
     * Looks whether a trial is over, under the same circumstances.
     *
     * @param trialId name of the trial
     * @param circumstances checksum of all that it depends on
     * @return whether its result is there now
     * @throws IOException if the folder cannot be read
     */
    public boolean load(String trialId, String circumstances) throws IOException {
        Path file = trialFile(trialId);
        if (!finished.containsKey(trialId) && Files.isRegularFile(file)) {
            String text = Files.readString(file);
            TrialJson.read(text, circumstances).ifPresent(kept -> {
                finished.put(trialId, kept);
                written.put(trialId, text);
            });
        }
        return finished.containsKey(trialId);
    }

    /**
     * Keeps a result.
     *
     * @param result the result
     * @param circumstances checksum of all that it depends on
     * @throws IOException if it cannot be written
     */
    public void save(TrialResult result, String circumstances) throws IOException {
        Path recording = recording(result.id());
        TrialJson.Kept kept =
                new TrialJson.Kept(result, Files.isRegularFile(recording) ? Fingerprint.sha256(recording) : "");
        String text = TrialJson.write(kept, circumstances);
        AtomicFile.write(trialFile(result.id()), text);
        finished.put(result.id(), kept);
        written.put(result.id(), text);
    }

    /**
     * Returns the checksum that the recording of a trial had when the trial was over.
     *
     * @param trialId name of the trial
     * @return its SHA-256; empty if it was not recorded
     */
    public Optional<String> recordingSha256(String trialId) {
        return Optional.ofNullable(finished.get(trialId))
                .map(TrialJson.Kept::recordingSha256)
                .filter(sum -> !sum.isEmpty());
    }

    /**
     * Looks for files that somebody else has changed while the contest ran, and restores the results.
     *
     * @return a sentence about each
     * @throws IOException if a file cannot be read or written
     */
    public List<String> repair() throws IOException {
        List<String> sentences = new ArrayList<>();
        for (Map.Entry<String, String> trial : new TreeMap<>(written).entrySet()) {
            Path file = trialFile(trial.getKey());
            if (!holds(file, trial.getValue().getBytes(StandardCharsets.UTF_8))) {
                AtomicFile.write(file, trial.getValue());
                sentences.add("Somebody has changed " + file + " while the contest ran; it is as it was again.");
            }
            Path recording = recording(trial.getKey());
            Optional<String> sum = recordingSha256(trial.getKey());
            if (sum.isPresent()
                    && Files.isRegularFile(recording)
                    && !Fingerprint.sha256(recording).equals(sum.get())) {
                sentences.add("Somebody has changed " + recording
                        + " since its trial; the checksum in the table is that of the trial.");
            }
        }
        return sentences;
    }

    /** What a program has put in place of a result may be huge, or a pipe. */
    private static boolean holds(Path file, byte[] content) {
        try {
            return Arrays.equals(RegularFile.read(file, content.length), content);
        } catch (UnreadableFileException another) {
            return false;
        }
    }

    @Override
    public Optional<TrialResult> find(String trialId) {
        return Optional.ofNullable(finished.get(trialId)).map(TrialJson.Kept::result);
    }

    @Override
    public void close() throws IOException {
        lock.close();
    }

    private Path trialFile(String trialId) {
        return folder.resolve("trials").resolve(trialId + ".json");
    }
}
