package org.robonewbie.studio.motion;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.motion.file.MotionFiles;
import org.robonewbie.nao.text.FileName;
import org.robonewbie.studio.file.FileVersion;
import org.robonewbie.studio.file.PageFolder;
import org.robonewbie.studio.file.PlainFile;
import org.robonewbie.studio.file.RefusedException;

/** Folder of motion files. Like agents, pages refer to a motion by its file name without the extension. */
class MotionFolder extends PageFolder {

    private static final String STUDIO = ".studio";

    private final MotionFiles files;

    private MotionFolder(Path folder, Optional<PageFolder> drafts) {
        super(folder, MotionFiles.MAX_BYTES, drafts);
        this.files = new MotionFiles(folder());
    }

    /** Returns the motions in a folder. */
    static MotionFolder of(Path folder) {
        return new MotionFolder(folder, Optional.of(drafts(folder)));
    }

    /** Returns the unsaved changes to the motions in a folder. */
    private static MotionFolder drafts(Path folder) {
        return new MotionFolder(folder.resolve(STUDIO).resolve("drafts"), Optional.empty());
    }

    /** Returns the file with the user's postures, which is empty at first. */
    static MotionFolder postures(Path folder) {
        return new MotionFolder(folder.resolve(STUDIO), Optional.empty()) {
            @Override
            public Optional<byte[]> read(String name) throws IOException {
                return super.read(name).or(() -> Optional.of(new byte[0]));
            }
        };
    }

    @Override
    public Listing list() {
        List<Entry> entries = new ArrayList<>();
        List<String> leftOut = new ArrayList<>(files.problems());
        for (String name : files.names()) {
            try {
                read(name).ifPresent(content -> entries.add(new Entry(name, FileVersion.of(content))));
            } catch (IOException | RefusedException unreadable) {
                leftOut.add(String.valueOf(unreadable.getMessage()));
            }
        }
        return new Listing(folder().toString(), entries, leftOut);
    }

    @Override
    public String kind() {
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
