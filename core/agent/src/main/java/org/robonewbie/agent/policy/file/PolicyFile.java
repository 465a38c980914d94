package org.robonewbie.agent.policy.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.nao.file.TextFile;

/**
 * Policy files in the format of {@link PolicyText}.
 *
 * <pre>{@code
 * walk.setPolicy(new PolicyWalk(PolicyFile.shipped("walk")));
 * walk.setPolicy(new PolicyWalk(PolicyFile.read(Path.of("my-walk.policy"))));
 * }</pre>
 */
public final class PolicyFile {

    private static final String FOLDER = "/policies/";
    private static final String ENDING = ".policy";

    private PolicyFile() {}

    /**
     * Loads a policy that is shipped with the framework.
     *
     * @param name {@code walk}, {@code jog}, {@code run}, {@code kick-to}, {@code stand}, {@code get-up}, {@code sprint} or {@code duel}
     * @return the policy
     * @throws IllegalArgumentException if there is no such policy
     */
    public static Policy shipped(String name) {
        try (InputStream stream = PolicyFile.class.getResourceAsStream(FOLDER + name + ENDING)) {
            if (stream == null) {
                throw new IllegalArgumentException("There is no shipped policy \"" + name + "\".");
            }
            return PolicyText.parse(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException("The shipped policy " + name + " cannot be read.", e);
        }
    }

    /**
     * Reads a policy file.
     *
     * @param file path of the file
     * @return the policy
     * @throws UncheckedIOException if the file cannot be read
     * @throws IllegalArgumentException if it contains no valid policy
     */
    public static Policy read(String file) {
        return read(Path.of(file));
    }

    /**
     * Reads a policy file.
     *
     * @param file the file
     * @return the policy
     * @throws UncheckedIOException if the file cannot be read
     * @throws IllegalArgumentException if it contains no valid policy
     */
    public static Policy read(Path file) {
        try {
            return PolicyText.parse(TextFile.readAndNote(file).content());
        } catch (IOException e) {
            throw new UncheckedIOException(e.getMessage(), e);
        } catch (IllegalArgumentException wrong) {
            throw new IllegalArgumentException(file + ": " + wrong.getMessage(), wrong);
        }
    }
}
