@echo off
rem Runs the agent of this project, or any other command of RoboNewbie.
cd /d "%~dp0"
set "JAVA=java"
if exist "%JAVA_HOME%\bin\java.exe" set "JAVA=%JAVA_HOME%\bin\java.exe"
if "%~1"=="" (
  "%JAVA%" -XX:+UseSerialGC -jar lib\org\robonewbie\robonewbie\2.0.0-built-b75416e3\robonewbie-2.0.0-built-b75416e3.jar run src/main/java/myteam/MyAgent.java
) else (
  "%JAVA%" -XX:+UseSerialGC -jar lib\org\robonewbie\robonewbie\2.0.0-built-b75416e3\robonewbie-2.0.0-built-b75416e3.jar %*
)
