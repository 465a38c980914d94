package org.robonewbie.studio.motion;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.studio.file.FileVersion;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.PlainFile;
import org.robonewbie.studio.file.RefusedException;

/** Folder of motion files. Like agents, pages refer to a motion by its file name without the extension. */
final class MotionFolder extends PageFolder {

    private final MotionFiles files;

    MotionFolder(Path folder) {
        super(folder, MotionFiles.MAX_BYTES);
        this.files = new MotionFiles(folder());
    }

    /**
     * Contents of the folder.
     *
     * @param entries the motions in alphabetical order
     * @param leftOut one message for each file that was omitted
     */
    record Listing(List<Entry> entries, List<String> leftOut) {}

    Listing list() {
        List<Entry> entries = new ArrayList<>();
        List<String> leftOut = new ArrayList<>(files.problems());
        for (String name : files.names()) {
            try {
                read(name).ifPresent(content -> entries.add(new Entry(name, FileVersion.of(content))));
            } catch (IOException | RefusedException unreadable) {
                leftOut.add(String.valueOf(unreadable.getMessage()));
            }
        }
        return new Listing(entries, leftOut);
    }

    @Override
    protected String kind() {
        return "motion";
    }

    @Override
    public Path file(String name) {
        FileName.problem(Normalizer.normalize(name, Normalizer.Form.NFC)).ifPresent(problem -> {
            throw new RefusedException(
                    400, "\"" + name + "\" is not a valid motion name: it " + problem + ". Choose another one.");
        });
        Path file = files.file(name);
        if (Files.exists(file) && !PlainFile.isInItsFolder(file)) {
            throw new RefusedException(403, "\"" + name + "\" is a link to a place outside " + folder() + ".");
        }
        return file;
    }
}
