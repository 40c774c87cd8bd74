<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
 <context>
  <name>QFileDialog</name>
  <message>
   <source>&amp;Look in:</source>
   <translation>查找范围(&amp;L)：</translation>
  </message>
  <message>
   <source>Files of &amp;type:</source>
   <translation>文件类型(&amp;T)：</translation>
  </message>
 </context>
 <context>
  <name>QAbstractFileIconProvider</name>
  <message>
   <source>%1 File</source>
   <translation>%1 文件</translation>
  </message>
  <message>
   <source>Alias</source>
   <translation>替身</translation>
  </message>
  <message>
   <source>Drive</source>
   <translation>驱动器</translation>
  </message>
  <message>
   <source>File</source>
   <translation>文件</translation>
  </message>
  <message>
   <source>File Folder</source>
   <translation>文件夹</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>文件夹</translation>
  </message>
  <message>
   <source>Shortcut</source>
   <translation>快捷方式</translation>
  </message>
  <message>
   <source>Unknown</source>
   <translation>未知</translation>
  </message>
 </context>
 <context>
  <name>QStandardPaths</name>
  <message>
   <source>Downloads</source>
   <translation>下载</translation>
  </message>
  <message>
   <source>Public</source>
   <translation>公共</translation>
  </message>
  <message>
   <source>Templates</source>
   <translation>模板</translation>
  </message>
 </context>
 <context>
  <name>QErrorMessage</name>
  <message>
   <source>An error occurred</source>
   <translation>发生错误</translation>
  </message>
 </context>
</TS>
