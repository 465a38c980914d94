package org.robonewbie.studio.file;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * Files that are part of the program, which pages can only read.
 *
 * @param kind the noun for one of them
 * @param names their names
 * @param reader reads the file with one of these names
 */
public record ShippedFiles(String kind, Collection<String> names, Function<String, Optional<byte[]>> reader)
        implements PageFiles {

    @Override
    public Listing list() {
        return new Listing("", names.stream().map(name -> new Entry(name, "")).toList(), List.of());
    }

    @Override
    public Optional<byte[]> read(String path) {
        return names.contains(path) ? reader.apply(path) : Optional.empty();
    }
}
