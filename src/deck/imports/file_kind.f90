!> Kinds of files that are not text tables, by their first bytes.
module dg_file_kind
   use dg_file_lines, only: file_begin
   use dg_text, only: lower_case
   implicit none
   private
   public :: foreign_kind, is_xml

   !> Bytes that are looked at.
   integer, parameter :: first_bytes = 1024

contains

   !> Kind of a file that is no text table, and advice on it. '' for any other file, and where it cannot be opened.
   function foreign_kind(path) result(kind)
      character(*), intent(in) :: path
      character(:), allocatable :: kind
      character(:), allocatable :: begin
      kind = ''
      begin = file_begin(path, first_bytes)
      if (begin /= '') kind = kind_of(begin)
   end function foreign_kind

   pure function kind_of(begin) result(kind)
      character(*), intent(in) :: begin
      character(:), allocatable :: kind
      character(*), parameter :: old_excel = char(208)//char(207)//char(17)//char(224)
      character(*), parameter :: csv = 'Save the sheet as CSV, and name that file'
      character(*), parameter :: unpack = 'Unpack it, and name the file that was in it'
      character(*), parameter :: export = 'Export the survey as CSV, and name that file'
      character(:), allocatable :: text
      kind = ''
      if (starts(begin, 'PK'//char(3)//char(4)) .or. starts(begin, 'PK'//char(5)//char(6))) then
         if (index(begin, 'opendocument.spreadsheet') > 0) then
            kind = 'is an OpenDocument sheet (ods). '//csv
         else if (index(begin, 'word/') > 0) then
            kind = 'is a Word document (docx). Save its table as CSV, and name that file'
         else if (index(begin, '[Content_Types].xml') > 0 .or. index(begin, 'xl/') > 0 .or. index(begin, '_rels/') > 0 .or. &
                  index(begin, 'docProps/') > 0) then
            kind = 'is an Excel workbook (xlsx). '//csv
         else
            kind = 'is a zip archive, as Excel workbooks (xlsx) are. Save the sheet as CSV, or unpack the archive'
         end if
      else if (starts(begin, old_excel)) then
         kind = 'is an Excel workbook of the old form (xls), or another Office document. '//csv
      else if (starts(begin, char(9)//char(8)//char(16)//char(0)) .or. starts(begin, char(9)//char(4)//char(6)//char(0))) then
         kind = 'is an old Excel sheet (xls). '//csv
      else if (starts(begin, '%PDF')) then
         kind = 'is a PDF document. Ask for the survey as CSV or text, or copy its table to a sheet and save that as CSV'
      else if (starts(begin, char(31)//char(139))) then
         kind = 'is compressed (gzip). '//unpack
      else if (starts(begin, 'BZh') .or. starts(begin, char(253)//'7zXZ') .or. starts(begin, '7z'//char(188)//char(175)) .or. &
               starts(begin, char(40)//char(181)//char(47)//char(253)) .or. starts(begin, 'Rar!')) then
         kind = 'is compressed. '//unpack
      else if (starts(begin, '{\rtf')) then
         kind = 'is a text with layout (RTF). Save it as plain text or CSV, and name that file'
      else if (starts(begin, char(137)//'PNG') .or. starts(begin, char(255)//char(216)//char(255)) .or. starts(begin, 'GIF8') .or. &
               starts(begin, 'II*'//char(0)) .or. starts(begin, 'MM'//char(0)//'*')) then
         kind = 'is a picture. '//export
      else if (starts(begin, char(137)//'HDF') .or. starts(begin, 'PAR1') .or. starts(begin, 'SQLite format')) then
         kind = 'is a binary data file (HDF5, Parquet or SQLite). '//export
      else if (index(begin(:min(len(begin), 100)), 'RECORD') > 0 .and. index(begin, 'V1.') > 0 .and. &
               index(begin, achar(0)) > 0) then
         kind = 'is a DLIS log. '//export
      end if
      if (kind /= '') return
      text = plain_begin(begin)
      if (starts(text, '<!doctype html') .or. starts(text, '<html') .or. starts(text, '<table')) then
         kind = 'is a web page (HTML). Open it in a spreadsheet, save the sheet as CSV, and name that file'
      else if (starts(text, '{') .or. is_list(text)) then
         kind = 'is JSON. '//export
      else if (index(begin, achar(0)) > 0 .and. .not. (starts(begin, char(255)//char(254)) .or. &
                                                      starts(begin, char(254)//char(255)))) then
         kind = 'is not text: it holds zero bytes. '//export
      end if
   end function kind_of

   !> True if a file is an XML document, a web page not counted.
   function is_xml(path) result(is)
      character(*), intent(in) :: path
      logical :: is
      is = starts(plain_begin(file_begin(path, first_bytes)), '<') .and. foreign_kind(path) == ''
   end function is_xml

   !> The first bytes in lower case, without a mark of byte order and what is blank before them.
   pure function plain_begin(begin) result(text)
      character(*), intent(in) :: begin
      character(:), allocatable :: text
      character(*), parameter :: byte_order_mark = char(239)//char(187)//char(191)
      text = begin
      if (starts(text, byte_order_mark)) text = begin(len(byte_order_mark) + 1:)
      text = lower_case(text(max(1, verify(text, ' '//achar(9)//achar(10)//achar(13))):))
   end function plain_begin

   pure function starts(text, with)
      character(*), intent(in) :: text, with
      logical :: starts
      starts = index(text, with) == 1
   end function starts

   !> True if a text begins with a list of JSON, not with a heading in brackets.
   pure function is_list(text)
      character(*), intent(in) :: text
      logical :: is_list
      integer :: next
      is_list = starts(text, '[')
      if (.not. is_list) return
      next = verify(text(2:), ' '//achar(9)//achar(10)//achar(13)) + 1
      is_list = next > 1
      if (is_list) is_list = scan(text(next:next), '[{') == 1
   end function is_list
end module dg_file_kind
