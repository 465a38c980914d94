package org.robonewbie.agent.policy.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.walk.PolicyWalk;

class PolicyFileTest {

    @TempDir
    private Path folder;

    @Test
    void shippedWalkReachesItsSpeed() {
        PolicyWalk walk = new PolicyWalk(PolicyFile.shipped("walk"));

        assertThat(walk.style().most().forward()).isEqualTo(0.8);
    }

    @Test
    void readsAPolicyOfYourOwn() throws IOException {
        Policy policy = PolicyFile.shipped("walk");
        Path file = Files.writeString(folder.resolve("my.policy"), PolicyText.format(policy));

        assertThat(new PolicyWalk(PolicyFile.read(file)).style()).isEqualTo(new PolicyWalk(policy).style());
    }

    @ParameterizedTest
    @CsvSource({"UTF-8, '\uFEFF', '\r\n'", "UTF-16LE, '\uFEFF', '\r\n'", "windows-1252, '', '\r'"})
    void readsAPolicyThatAnEditorHasSaved(String encoding, String mark, String end) throws IOException {
        Policy policy = PolicyFile.shipped("walk");
        String text = mark + (PolicyText.format(policy) + "# für später\n").replace("\n", end);
        Path file = Files.write(folder.resolve("my.policy"), text.getBytes(Charset.forName(encoding)));

        assertThat(new PolicyWalk(PolicyFile.read(file)).style()).isEqualTo(new PolicyWalk(policy).style());
    }

    @Test
    void fileThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("my.zip"), new byte[] {'P', 'K', 0, (byte) 0x81});

        assertThatThrownBy(() -> PolicyFile.read(file))
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }

    @Test
    void namesTheFileThatIsMissingOrWrong() throws IOException {
        Path wrong = Files.writeString(folder.resolve("wrong.policy"), "200 1 2 3");

        assertThatThrownBy(() -> PolicyFile.read(folder.resolve("none.policy")))
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageContaining("none.policy does not exist");
        assertThatThrownBy(() -> PolicyFile.read(wrong))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("wrong.policy: Line 1 of the policy cannot be read");
        assertThatThrownBy(() -> PolicyFile.shipped("fly")).hasMessage("There is no shipped policy \"fly\".");
    }
}
