package org.robonewbie.web.compiling;

import java.util.Collection;
import java.util.stream.Stream;
import org.robonewbie.nao.motion.file.ShippedMotions;
import org.teavm.extension.spi.resources.ResourcesPolicy;

/** TeaVM policy that adds resources to the module: the motions, and the German findings and hints. */
public final class ShippedFiles implements ResourcesPolicy {

    /** Creates the policy; TeaVM finds it by name. */
    public ShippedFiles() {}

    @Override
    public String[] supplyResources(Collection<? extends String> classes) {
        Stream<String> motions = new ShippedMotions().names().stream().map(name -> name + ".txt");
        return Stream.concat(
                        Stream.concat(Stream.of("index"), motions).map(file -> "motions/" + file),
                        ProgramsCall.WITHOUT_PROGRAMS ? Stream.of() : translations())
                .toArray(String[]::new);
    }

    private static Stream<String> translations() {
        return Stream.of("hints-de.txt", "findings-de.txt").map(file -> "org/robonewbie/exercises/" + file);
    }
}
