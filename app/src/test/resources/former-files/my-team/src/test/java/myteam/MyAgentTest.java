package myteam;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.motion.file.MotionFiles;

class MyAgentTest {

    @Test
    void greetingCanBePlayed() throws Exception {
        assertTrue(MotionFiles.library().find("greet").isPresent());
    }

    @Test
    void livesForTenSecondsWithoutAMistake() {
        MyAgent.main(new String[] {"--headless", "--fast", "--seed", "1", "--seconds", "10"});
    }
}
