package org.robonewbie.studio;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.robonewbie.programs.Remark;
import org.robonewbie.programs.completion.Proposal;
import org.robonewbie.studio.program.CompilerService;
import org.robonewbie.studio.program.RunningProgram;

/** A compiler service without a compiler: it reports one fixed error, and no program runs. */
record SmallWorkshop(Path folder) implements CompilerService {

    static final String MISTAKE = "degres";

    private static final String EXAMPLE = "Agent_Wave";
    private static final String PROGRAM = "public class MyAgent {\n    int degrees = 45;\n}\n";

    @Override
    public List<String> examples() {
        return List.of(EXAMPLE);
    }

    @Override
    public Optional<String> example(String name) {
        return name.equals(EXAMPLE) ? Optional.of(PROGRAM.replace("MyAgent", EXAMPLE)) : Optional.empty();
    }

    @Override
    public String newProgram(Path file, Optional<String> text) {
        return text.orElse(PROGRAM);
    }

    @Override
    public List<Remark> check(Path file, String text) {
        int at = text.indexOf(MISTAKE);
        int line = (int) text.substring(0, Math.max(0, at)).lines().count();
        return at < 0
                ? List.of()
                : List.of(new Remark(
                        at, at + MISTAKE.length(), line, true, "cannot find symbol", "Is the name written right?"));
    }

    @Override
    public List<Proposal> complete(Path file, String text, int at) {
        return List.of(new Proposal("degrees", ": int", "property", "degrees", "An angle."));
    }

    @Override
    public Optional<RunningProgram> start(Path file, int port, Runnable beforeStart) {
        return Optional.empty();
    }
}
