package org.robonewbie.web.library.org.robonewbie.nao.motion.file;

import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.robonewbie.nao.motion.MotionLibrary;
import org.robonewbie.nao.motion.MotionSource;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.robonewbie.web.PageMemory;

/** Motions that the user has made in the page, kept in memory because a page has no folder. */
public final class PageMotionFiles implements MotionSource {

    private PageMotionFiles() {}

    /** {@return the available motions: the user's and the built-in ones} */
    public static MotionLibrary library() {
        return new MotionLibrary(new PageMotionFiles(), new ShippedMotions());
    }

    @Override
    public Optional<byte[]> read(String name) {
        return Optional.ofNullable(PageMemory.motions().get(name));
    }

    @Override
    public SortedSet<String> names() {
        return new TreeSet<>(PageMemory.motions().keySet());
    }
}
